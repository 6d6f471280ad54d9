// What an emulator's log says of loops for arm64.
#include "harness/measure/emulated_loops.h"

#include <elf.h>
#include <gtest/gtest.h>

#include <cstring>
#include <stdexcept>
#include <string>

#include "harness/input/name_filter.h"

namespace pitbench {
namespace {

constexpr char kLine[] = "Trace 0: 0x7f06 [0000000001009311/%/00000001/201] f";

std::string At(const std::string& address) {
  std::string line = kLine;
  return line.replace(line.find('%'), 1, address);
}

TEST(EmulationLogTest, OnlyWhatRunsInACallIsKept) {
  EmulationLog log;
  log.Read(At("400100"));
  log.Read("kernel cross_product f32 sve 256 64");
  log.Read(At("400200"));
  for (const char* address : {"400300", "400304"}) {
    log.Read("call");
    log.Read(At(address));
    log.Read("done");
    log.Read(At("400200"));
  }
  ASSERT_EQ(log.kernels().size(), 1u);
  const EmulatedKernel& kernel = log.kernels().front();
  EXPECT_EQ(kernel.method, "cross_product");
  EXPECT_EQ(kernel.isa, "sve");
  EXPECT_EQ(kernel.vector_bits, 256);
  EXPECT_EQ(kernel.n, 64u);
  EXPECT_EQ(kernel.calls, (std::vector<Trace>{{0x400300}, {0x400304}}));
}

TEST(EmulationLogTest, OtherLinesAreErrors) {
  for (const char* line :
       {"call", "done", "kernel cross_product", "qemu: uncaught signal"}) {
    EmulationLog log;
    EXPECT_THROW(log.Read(line), std::runtime_error) << line;
  }
  EmulationLog log;
  log.Read("kernel a f32 neon 128 64");
  log.Read("call");
  EXPECT_THROW(log.Read("Trace 0: nothing"), std::runtime_error);
}

TEST(EmulatedLoopsTest, InstructionsAreReadWhereTheProgramHasThem) {
  Elf64_Ehdr header = {};
  std::memcpy(header.e_ident, "\x7f\x45LF\x02", 5);
  header.e_phoff = sizeof header;
  header.e_phnum = 1;
  Elf64_Phdr segment = {};
  segment.p_type = PT_LOAD;
  segment.p_offset = sizeof header + sizeof segment;
  segment.p_vaddr = 0x400000;
  segment.p_filesz = 8;
  std::string elf(sizeof header + sizeof segment, '\0');
  std::memcpy(elf.data(), &header, sizeof header);
  std::memcpy(elf.data() + sizeof header, &segment, sizeof segment);
  elf += "\x01\x02\x03\x04\x20\xcc\x22\x4e";
  EXPECT_EQ(Arm64InstructionBytes(elf, 0x400004), "20cc224e");
  EXPECT_THROW(Arm64InstructionBytes(elf, 0x400008), std::runtime_error);
  EXPECT_THROW(Arm64InstructionBytes("#!/bin/sh", 0), std::runtime_error);
}

TEST(EmulatedLoopsTest, WithoutTheProgramThereAreNoRowsButAReason) {
  const EmulatedLoops loops = EmulateLoops("/nonexistent", NameFilter("."));
  EXPECT_TRUE(loops.rows.empty());
  EXPECT_NE(loops.reason.find("aarch64-linux-gnu-g++"), std::string::npos);
}

}  // namespace
}  // namespace pitbench
