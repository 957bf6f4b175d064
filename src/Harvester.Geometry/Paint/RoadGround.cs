namespace Harvester.Geometry.Paint;

/// <summary>
/// The ground of the road network, moved and tilted so that it passes under the vehicle that carries the camera:
/// z = z of the network + d + g · (p - p0), with p0 the point under the vehicle, d and g chosen so that height and slope at p0 are those of
/// the ground under the wheels.
/// </summary>
public sealed class RoadGround : IPaintGround
{
    /// <summary>Standard deviation of the height under the vehicle, metres: suspension and tyres.</summary>
    private const double SigmaAtVehicle = 0.01;

    /// <summary>Growth of the standard deviation, metres per metre: what remains of changes of slope between nodes.</summary>
    private const double SigmaGrowth = 0.0015;

    private readonly Vector3D _contact;
    private readonly double _offset;
    private readonly Vector2D _across;
    private readonly double _tilt;

    /// <summary>Uses the network's heights as they are.</summary>
    public RoadGround() { }

    /// <summary>Creates the ground under a vehicle.</summary>
    /// <param name="contact">The point of the ground under the vehicle, metres, world.</param>
    /// <param name="axes">The axes of the vehicle, which stands on the ground.</param>
    /// <param name="networkHeight">The height of the road network there, metres.</param>
    public RoadGround(Vector3D contact, Axes axes, double networkHeight)
    {
        _contact = Guard.Finite(contact, nameof(contact));
        Guard.Orientation(axes, nameof(axes));
        _offset = contact.Z - Guard.Finite(networkHeight, nameof(networkHeight));

        // The network has no slope across the road; the vehicle's right axis has it. Along the road the network's own slope is used,
        // because the body of an accelerating or braking vehicle pitches.
        var right = new Vector2D(axes.Right.X, axes.Right.Y);
        double length = right.Length;
        if (length > 0)
        {
            _across = right * (1 / length);
            _tilt = axes.Right.Z / length;
        }
    }

    /// <inheritdoc/>
    public double HeightAt(Vector3D place) =>
        place.Z + _offset + (_tilt * new Vector2D(place.X - _contact.X, place.Y - _contact.Y).Dot(_across));

    /// <inheritdoc/>
    public double SigmaAt(double distance) => SigmaAtVehicle + (SigmaGrowth * Math.Max(0, distance));
}
