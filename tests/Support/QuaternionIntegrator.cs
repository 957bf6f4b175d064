using Harvester.Geometry;
using Harvester.Sessions.Labels;

namespace Harvester.TestSupport;

/// <summary>
/// Integrates the samples of an inertial unit as a strapdown mechanisation does, with quaternions in double precision: attitude by the
/// rotation of each interval, velocity by the specific force in the attitude at its middle, position by the mean velocity.
/// </summary>
internal sealed class QuaternionIntegrator
{
    private const double Gravity = 9.80665;

    private double _w;
    private Vector3D _v;
    private double _seconds;

    public QuaternionIntegrator(Axes axes, Vector3D velocity, double seconds, Vector3D position = default)
    {
        // Right, forward and up are the columns of the rotation matrix.
        (_w, _v) = OfColumns(axes.Right, axes.Forward, axes.Up);
        (Velocity, _seconds, Position) = (velocity, seconds, position);
    }

    public Vector3D Velocity { get; private set; }

    public Vector3D Position { get; private set; }

    public Vector3D ToWorld(Vector3D body)
    {
        // v' = v + 2 w (q × v) + 2 q × (q × v)
        Vector3D crossed = _v.Cross(body);
        return body + (crossed * (2 * _w)) + (_v.Cross(crossed) * 2);
    }

    public void Add(ImuSample sample)
    {
        double interval = sample.TimeSeconds - _seconds;
        _seconds = sample.TimeSeconds;
        Vector3D half = sample.AngularRate * (interval / 2);
        Turn(half);
        Vector3D change = (ToWorld(sample.SpecificForce) - new Vector3D(0, 0, Gravity)) * interval;
        Turn(half);
        Position += (Velocity + (change * 0.5)) * interval;
        Velocity += change;
    }

    /// <summary>Multiplies by the quaternion of a rotation vector, (cos(a/2), sin(a/2) axis).</summary>
    private void Turn(Vector3D rotation)
    {
        double angle = rotation.Length;
        double w = Math.Cos(angle / 2);
        Vector3D v = rotation * (angle < 1e-12 ? 0.5 : Math.Sin(angle / 2) / angle);
        (_w, _v) = ((_w * w) - _v.Dot(v), (v * _w) + (_v * w) + _v.Cross(v));
    }

    private static (double W, Vector3D V) OfColumns(Vector3D x, Vector3D y, Vector3D z)
    {
        // q = (1 + trace, antisymmetric part), which holds unless the angle is near π; then turn by π about an axis first.
        double trace = x.X + y.Y + z.Z;
        if (trace > -0.5)
        {
            double w = Math.Sqrt(1 + trace) / 2;
            return (w, new Vector3D(y.Z - z.Y, z.X - x.Z, x.Y - y.X) / (4 * w));
        }

        double[] squares = [(1 + x.X - y.Y - z.Z) / 4, (1 - x.X + y.Y - z.Z) / 4, (1 - x.X - y.Y + z.Z) / 4];
        int largest = Array.IndexOf(squares, squares.Max());
        double part = Math.Sqrt(squares[largest]);
        double fourth = 1 / (4 * part);
        return largest switch
        {
            0 => ((y.Z - z.Y) * fourth, new Vector3D(part, (x.Y + y.X) * fourth, (x.Z + z.X) * fourth)),
            1 => ((z.X - x.Z) * fourth, new Vector3D((x.Y + y.X) * fourth, part, (y.Z + z.Y) * fourth)),
            _ => ((x.Y - y.X) * fourth, new Vector3D((x.Z + z.X) * fourth, (y.Z + z.Y) * fourth, part)),
        };
    }
}
