using Harvester.Geometry;
using Harvester.Simulation.Crashes;
using Harvester.Simulation.Models;
using Harvester.Simulation.Streets;

namespace Harvester.Simulation.Traffic;

/// <summary>A vehicle after an impact: it slides to rest on locked wheels, or on its side if it has two, and stays.</summary>
/// <param name="body">Its motion on the ground.</param>
/// <param name="model">Its model.</param>
/// <param name="extents">The corners of its box in the model's frame, metres.</param>
/// <param name="groundHeight">Height of the ground below it, metres.</param>
internal sealed class Wreck(PlanarBody body, Model model, (Vector3D Min, Vector3D Max) extents, double groundHeight)
{
    /// <summary>Time in which a two-wheeler falls, seconds: about that of a rod of its height.</summary>
    private const double FallSeconds = 0.6;

    /// <summary>A two-wheeler falls to the side to which it is thrown.</summary>
    private readonly bool _fallsLeft = body.Left.Dot(body.Velocity) >= 0;
    private double _fallenSeconds;

    public PlanarBody Body { get; } = body;

    public bool IsAtRest => Body.IsAtRest && !(Falls && _fallenSeconds < FallSeconds);

    private bool Falls { get; } = VehicleMass.IsTwoWheeler(model);

    public double DecelerationOn(RoadGrip grip) => Falls ? grip.LyingSlide : grip.Sliding;

    /// <summary>Height of the ground below it, metres, as last found.</summary>
    public double GroundHeight { get; set; } = groundHeight;

    /// <summary>Lets time pass for its fall.</summary>
    public void Tick(double seconds) => _fallenSeconds += seconds;

    /// <summary>Its pose on the ground.</summary>
    /// <param name="slope">Rise of the ground per metre in its direction.</param>
    public Pose PoseOn(double slope)
    {
        Vector2D forward = Body.Forward;
        Axes upright = Horizontal.AxesAlong((new Vector3D(forward.X, forward.Y, 0) + (Horizontal.Up * slope)).Normalized());
        Axes axes = Falls ? Leaning(upright) : upright;

        // The lowest corner of the box stands on the ground: the middle is above it by the box's reach along the vertical.
        Vector3D half = (extents.Max - extents.Min) * 0.5;
        double above = (Math.Abs(axes.Up.Z) * half.Z) + (Math.Abs(axes.Right.Z) * half.X);
        Vector3D middle = new(Body.Position.X, Body.Position.Y, GroundHeight + above);
        return new Pose(middle - axes.ToWorld((extents.Min + extents.Max) * 0.5), axes);
    }

    private Axes Leaning(Axes upright)
    {
        // A fall begins slowly: the angle grows with the square of time, up to a quarter turn about the length.
        double share = Math.Min(1, _fallenSeconds / FallSeconds);
        double angle = Math.PI / 2 * share * share * (_fallsLeft ? -1 : 1);
        Vector3D right = (upright.Right * Math.Cos(angle)) - (upright.Up * Math.Sin(angle));
        return Axes.FromVectors(right, upright.Forward, right.Cross(upright.Forward));
    }
}
