// A ray and a triangle as integers, and the determinants that decide about
// them.
#ifndef PITBENCH_HARNESS_TRUTH_RAY_INTEGERS_H_
#define PITBENCH_HARNESS_TRUTH_RAY_INTEGERS_H_

#include <gmpxx.h>

#include <array>
#include <cstddef>
#include <span>

#include "harness/truth/ray_truth.h"
#include "harness/truth/scaled_integers.h"

namespace pitbench {

using IntegerVector = std::span<const mpz_class, 3>;

// Seen from O: a = A − O, b = B − O, c = C − O, the edges e = B − A and
// f = C − A, all in units of 2^length, and D = d in units of 2^direction.
// Apart, because the length of D is often another than those of the
// coordinates, and what it is multiplies all determinants alike.
//
//   facing      = d·(e × f)
//   weights[k]  = d·(b × c), d·(c × a), d·(a × b): of A, B and C, times facing
//   height      = a·(e × f): t times facing, in units of 2^(length − direction)
//
// For A' = A − O and so on, t·D is the sum of w_k times the vertices, so
// t·D·(B' × C') = w_A·A'·(B' × C'), and A'·(B' × C') = A'·(e × f) = t·D·(e ×
// f).
//
// One object is used again and again: nothing is allocated once the integers
// have grown to the size that the values need.
class RayIntegers {
 public:
  // Precondition: finite, but for t_max.
  template <class T>
  void Take(const Triangle3<T>& t, const Ray<T>& ray) {
    const Point3<T>& o = ray.origin;
    const Point3<T>& d = ray.direction;
    length_ = ScaleToIntegers<T, 12>({t.a.x, t.a.y, t.a.z, t.b.x, t.b.y, t.b.z,
                                      t.c.x, t.c.y, t.c.z, o.x, o.y, o.z},
                                     points_);
    direction_ = ScaleToIntegers<T, 3>({d.x, d.y, d.z}, d_);
    for (std::size_t k = 0; k < 3; ++k) {
      e_[k] = points_[3 + k] - points_[k];
      f_[k] = points_[6 + k] - points_[k];
      for (std::size_t vertex = 0; vertex < 3; ++vertex) {
        seen_[3 * vertex + k] = points_[3 * vertex + k] - points_[9 + k];
      }
    }
  }

  int length() const { return length_; }
  int direction() const { return direction_; }
  // A, B, C and O.
  const std::array<mpz_class, 12>& coordinates() const { return points_; }
  IntegerVector d() const { return d_; }
  IntegerVector e() const { return e_; }
  IntegerVector f() const { return f_; }

  // Each of these is valid until the next is asked for.
  const mpz_class& Facing() { return Determinant(d_, e_, f_); }
  const mpz_class& Weight(std::size_t k) {
    return Determinant(d_, Seen((k + 1) % 3), Seen((k + 2) % 3));
  }
  const mpz_class& Height() { return Determinant(Seen(0), e_, f_); }

  // Component k of e × f.
  const mpz_class& Normal(std::size_t k) {
    Cross(e_, f_, k);
    return minor_;
  }

 private:
  IntegerVector Seen(std::size_t vertex) const {
    return std::span(seen_).subspan(3 * vertex).first<3>();
  }
  void Cross(IntegerVector q, IntegerVector r, std::size_t k) {
    const std::size_t i = (k + 1) % 3;
    const std::size_t j = (k + 2) % 3;
    mpz_mul(minor_.get_mpz_t(), q[i].get_mpz_t(), r[j].get_mpz_t());
    mpz_submul(minor_.get_mpz_t(), q[j].get_mpz_t(), r[i].get_mpz_t());
  }
  const mpz_class& Determinant(IntegerVector p, IntegerVector q,
                               IntegerVector r) {
    determinant_ = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      Cross(q, r, k);
      mpz_addmul(determinant_.get_mpz_t(), p[k].get_mpz_t(),
                 minor_.get_mpz_t());
    }
    return determinant_;
  }

  std::array<mpz_class, 12> points_;
  std::array<mpz_class, 9> seen_;  // a, b, c
  std::array<mpz_class, 3> d_, e_, f_;
  int length_ = 0;
  int direction_ = 0;
  mpz_class minor_;
  mpz_class determinant_;
};

}  // namespace pitbench

#endif  // PITBENCH_HARNESS_TRUTH_RAY_INTEGERS_H_
