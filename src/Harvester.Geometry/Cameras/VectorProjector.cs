#if NET
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;

namespace Harvester.Geometry.Cameras;

/// <summary>
/// Projects four points at a time with the operations of <see cref="Camera.Project"/> in the same order, so that the results are identical
/// to the last bit. Requires AVX and a lens without distortion.
/// </summary>
internal static class VectorProjector
{
    private const int Lanes = 4;
    private const int DoublesPerPoint = 3;
    private const int DoublesPerProjection = 4;

    /// <summary>Whether the processor has AVX and the lens has no distortion.</summary>
    public static bool CanProject(Lens lens) => Avx.IsSupported && lens.IsRectilinear;

    /// <summary>Projects points in order until fewer than four remain or a point is not finite.</summary>
    /// <returns>Number of points projected.</returns>
    public static int Project(Camera camera, ReadOnlySpan<Vector3D> world, Span<Projection> projections)
    {
        ReadOnlySpan<double> from = MemoryMarshal.Cast<Vector3D, double>(world);
        Span<double> to = MemoryMarshal.Cast<Projection, double>(projections);
        var frame = new Frame(camera);
        int done = 0;
        for (; done <= world.Length - Lanes; done += Lanes)
        {
            (Vector256<double> x, Vector256<double> y, Vector256<double> z) = Coordinates(from.Slice(done * DoublesPerPoint));

            // A number minus itself is 0, except for infinity and NaN, for which it is NaN and equal to nothing.
            if (!Vector256.EqualsAll((x - x) + (y - y) + (z - z), Vector256<double>.Zero))
            {
                break;
            }

            frame.Project(x, y, z, to.Slice(done * DoublesPerProjection));
        }

        return done;
    }

    /// <summary>Four points, as one vector each of x, y and z.</summary>
    private static (Vector256<double> X, Vector256<double> Y, Vector256<double> Z) Coordinates(ReadOnlySpan<double> points)
    {
        Vector256<double> a = Vector256.Create(points);
        Vector256<double> b = Vector256.Create(points.Slice(Lanes));
        Vector256<double> c = Vector256.Create(points.Slice(2 * Lanes));

        // In memory: a = x0 y0 z0 x1, b = y1 z1 x2 y2, c = z2 x3 y3 z3. Halves are joined first, then elements are picked from each half.
        Vector256<double> xy = Avx.Permute2x128(a, b, 0x30);
        Vector256<double> zx = Avx.Permute2x128(a, c, 0x21);
        Vector256<double> yz = Avx.Permute2x128(b, c, 0x30);
        return (Avx.Shuffle(xy, zx, 0b1010), Avx.Shuffle(xy, yz, 0b0101), Avx.Shuffle(zx, yz, 0b1010));
    }

    /// <summary>A camera's parameters, each repeated in all four elements.</summary>
    private readonly ref struct Frame
    {
        private readonly Vector256<double> _positionX,
            _positionY,
            _positionZ;
        private readonly Vector256<double> _rightX,
            _rightY,
            _rightZ;
        private readonly Vector256<double> _forwardX,
            _forwardY,
            _forwardZ;
        private readonly Vector256<double> _upX,
            _upY,
            _upZ;
        private readonly Vector256<double> _near,
            _fx,
            _fy,
            _cx,
            _cy,
            _width,
            _height;

        public Frame(Camera camera)
        {
            (_positionX, _positionY, _positionZ) = Spread(camera.Pose.Position);
            (_rightX, _rightY, _rightZ) = Spread(camera.Pose.Axes.Right);
            (_forwardX, _forwardY, _forwardZ) = Spread(camera.Pose.Axes.Forward);
            (_upX, _upY, _upZ) = Spread(camera.Pose.Axes.Up);
            CameraIntrinsics intrinsics = camera.Intrinsics;
            _near = Vector256.Create(intrinsics.NearClip);
            _fx = Vector256.Create(intrinsics.Fx);
            _fy = Vector256.Create(intrinsics.Fy);
            _cx = Vector256.Create(intrinsics.Cx);
            _cy = Vector256.Create(intrinsics.Cy);
            _width = Vector256.Create((double)intrinsics.Image.Width);
            _height = Vector256.Create((double)intrinsics.Image.Height);
        }

        public void Project(Vector256<double> x, Vector256<double> y, Vector256<double> z, Span<double> to)
        {
            x -= _positionX;
            y -= _positionY;
            z -= _positionZ;
            Vector256<double> depth = (_forwardX * x) + (_forwardY * y) + (_forwardZ * z);
            Vector256<double> u = _cx + (_fx * (((_rightX * x) + (_rightY * y) + (_rightZ * z)) / depth));
            Vector256<double> v = _cy + (_fy * (-((_upX * x) + (_upY * y) + (_upZ * z)) / depth));
            Vector256<double> isBehind = Vector256.LessThan(depth, _near);
            Vector256<double> isInImage =
                Vector256.GreaterThanOrEqual(u, Vector256<double>.Zero)
                & Vector256.GreaterThanOrEqual(v, Vector256<double>.Zero)
                & Vector256.LessThan(u, _width)
                & Vector256.LessThan(v, _height);
            Vector256<long> outcome = Vector256.ConditionalSelect(
                isBehind.AsInt64(),
                Vector256.Create((long)ProjectionOutcome.BehindNearPlane),
                Vector256.ConditionalSelect(
                    isInImage.AsInt64(),
                    Vector256.Create((long)ProjectionOutcome.InImage),
                    Vector256.Create((long)ProjectionOutcome.OutsideImage)
                )
            );
            Write(Vector256.AndNot(u, isBehind), Vector256.AndNot(v, isBehind), depth, outcome.AsDouble(), to);
        }

        private static void Write(
            Vector256<double> u,
            Vector256<double> v,
            Vector256<double> depth,
            Vector256<double> outcome,
            Span<double> to
        )
        {
            Vector256<double> pixels02 = Avx.UnpackLow(u, v);
            Vector256<double> pixels13 = Avx.UnpackHigh(u, v);
            Vector256<double> rest02 = Avx.UnpackLow(depth, outcome);
            Vector256<double> rest13 = Avx.UnpackHigh(depth, outcome);
            Avx.Permute2x128(pixels02, rest02, 0x20).CopyTo(to);
            Avx.Permute2x128(pixels13, rest13, 0x20).CopyTo(to.Slice(DoublesPerProjection));
            Avx.Permute2x128(pixels02, rest02, 0x31).CopyTo(to.Slice(2 * DoublesPerProjection));
            Avx.Permute2x128(pixels13, rest13, 0x31).CopyTo(to.Slice(3 * DoublesPerProjection));
        }

        private static (Vector256<double> X, Vector256<double> Y, Vector256<double> Z) Spread(Vector3D vector) =>
            (Vector256.Create(vector.X), Vector256.Create(vector.Y), Vector256.Create(vector.Z));
    }
}
#endif
