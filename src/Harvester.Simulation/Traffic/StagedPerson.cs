using Harvester.Geometry;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Models;
using Harvester.Simulation.People;
using Harvester.Simulation.Rendering;
using Harvester.Simulation.Streets;

namespace Harvester.Simulation.Traffic;

/// <summary>A person on foot whom somebody has put into the world.</summary>
internal sealed class StagedPerson : IPerson
{
    private Skeleton? _skeleton;
    private double _walked;
    private ThrownPerson? _thrown;

    /// <param name="handle">The handle.</param>
    /// <param name="model">A person's model.</param>
    /// <param name="motion">How it moves.</param>
    public StagedPerson(int handle, Model model, StagedMotion motion) => (Handle, Model, Motion) = (handle, model, motion);

    public int Handle { get; }

    public Model Model { get; }

    /// <summary>How it moves.</summary>
    public StagedMotion Motion { get; }

    /// <summary>Whether it is on a carriageway, where drivers brake for it.</summary>
    public bool IsOnRoad { get; private set; }

    public Pose Pose { get; private set; }

    public Footprint Footprint => _thrown?.Footprint ?? Footprint.Of(Pose, Model.Min, Model.Max);

    public Vector3D Velocity => _thrown?.Velocity ?? Motion.Velocity;

    public bool IsThrown => _thrown is not null;

    public Mesh Look => Model.Variants[Posture];

    public Skeleton Skeleton => _skeleton ??= Model.Skeletons[Posture].MovedBy(Pose);

    private int Posture =>
        Motion.Speed > 0
            ? (int)(_walked / Model.StrideMetres * PersonPoses.Phases) % PersonPoses.Phases
            : PersonPoses.FirstStanding + (Handle % PersonPoses.StandingCount);

    /// <summary>Walks on.</summary>
    /// <param name="seconds">The time step.</param>
    /// <param name="ground">The ground, whose height it takes.</param>
    public void Tick(double seconds, StagedGround ground)
    {
        if (_thrown is { } thrown)
        {
            thrown.Tick(seconds);
            Lie(thrown);
            return;
        }

        Motion.Pass(seconds);
        StagedStep step = Motion.After(seconds);
        _walked += Math.Max(0, step.Along - Motion.Along);
        Motion.Take(step);
        Stand(ground);
    }

    /// <summary>Puts it on the ground where it is.</summary>
    public void Stand(StagedGround ground)
    {
        (double height, bool isOnRoad) = ground.At(Motion.Ground);
        Motion.Stand(height);
        IsOnRoad = isOnRoad;
        Axes axes = Horizontal.AxesAlong(Motion.Forward);
        Pose = new Pose(Motion.Ground - (axes.Up * Model.Min.Z), axes);
        _skeleton = null;
    }

    public void Throw(Vector3D clear, Vector2D velocity, Func<Vector3D, double, double> groundAt)
    {
        _thrown = new ThrownPerson(Model, Pose with { Position = Pose.Position + clear }, velocity, groundAt);
        IsOnRoad = true;
        Lie(_thrown);
    }

    private void Lie(ThrownPerson thrown)
    {
        Motion.Displace(thrown.Footprint.Centre with { Z = Motion.Ground.Z }, Motion.Forward, 0);
        Pose = thrown.Pose;
        _skeleton = null;
    }
}
