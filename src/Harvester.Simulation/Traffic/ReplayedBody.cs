using Harvester.Geometry;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Models;
using Harvester.Simulation.People;
using Harvester.Simulation.Rendering;
using Harvester.Simulation.Settings;

namespace Harvester.Simulation.Traffic;

/// <summary>Something that moves as it was recorded.</summary>
/// <param name="handle">The handle.</param>
/// <param name="riderHandle">Handle of its rider; 0 without one.</param>
/// <param name="model">Its model.</param>
/// <param name="track">What it does.</param>
internal sealed class ReplayedBody(int handle, int riderHandle, Model model, ReplayTrack track)
{
    /// <summary>Who is slower stands, metres per second.</summary>
    private const double Standing = 0.2;

    private double _walked;
    private bool _isWalking;

    /// <summary>Its pose; meaningful while it is there.</summary>
    public Pose Pose { get; private set; }

    /// <summary>Metres per second, world.</summary>
    public Vector3D Velocity { get; private set; }

    /// <summary>Whether it is there.</summary>
    public bool IsThere { get; private set; }

    public int Handle => handle;

    private Model? Rider => model.Riders.Count > 0 ? model.Riders[0] : null;

    private int Posture =>
        _isWalking
            ? (int)(_walked / model.StrideMetres * PersonPoses.Phases) % PersonPoses.Phases
            : PersonPoses.FirstStanding + (handle % PersonPoses.StandingCount);

    /// <summary>Moves it to a time.</summary>
    /// <param name="step">The step before the time.</param>
    /// <param name="part">Where the time is between that step and the next, 0 to 1.</param>
    /// <param name="seconds">Time since it was moved last.</param>
    /// <param name="ground">The ground.</param>
    public void MoveTo(int step, double part, double seconds, StagedGround ground)
    {
        ReplayState? state = ReplayedPlace.Between(track.States, step, part);
        IsThere = state is not null;
        if (state is { } known)
        {
            Pose = ReplayedPlace.PoseOf(known, model, ground);
            Velocity = new Vector3D(known.Velocity.X, known.Velocity.Y, 0);
            _isWalking = known.Velocity.Length >= Standing && model.StrideMetres > 0;
            _walked += known.Velocity.Length * seconds;
        }
    }

    /// <summary>Its meshes: itself, its lamps and its rider, who is an entity of its own.</summary>
    public IEnumerable<MeshInstance> Instances(bool isDark)
    {
        yield return new MeshInstance(model.Skeletons.Count > 0 ? model.Variants[Posture] : model.Variant(handle), Pose, handle);
        if (model.Lamps?.Of(LightsIn(isDark)) is { } lamps)
        {
            yield return new MeshInstance(lamps, Pose, handle);
        }

        if (Rider is { } rider)
        {
            yield return new MeshInstance(rider.Mesh, Pose, riderHandle);
        }
    }

    /// <summary>Itself and its rider, as a game reports them.</summary>
    public IEnumerable<EntityState> Entities(bool isDark)
    {
        yield return new EntityState(handle, model.Class, model.Name, Pose, model.Min, model.Max, Velocity)
        {
            HasRider = VehicleClasses.HaveRiders(model.Class) ? true : null,
            Lights = VehicleClasses.AreVehicles(model.Class) ? LightsIn(isDark) : null,
            Skeleton = model.Skeletons.Count > 0 ? model.Skeletons[Posture].MovedBy(Pose) : null,
        };
        if (Rider is { } rider)
        {
            yield return new EntityState(riderHandle, ObjectClass.Rider, rider.Name, Pose, rider.Min, rider.Max, Velocity)
            {
                VehicleHandle = handle,
                Skeleton = rider.Skeletons[0].MovedBy(Pose),
            };
        }
    }

    /// <summary>Logs do not tell which lamps shine, only the time of day does.</summary>
    private static VehicleLights LightsIn(bool isDark) => new(false, false, false, isDark);
}
