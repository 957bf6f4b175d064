using Harvester.Geometry.Motion;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Labelling;

/// <summary>What the flow to the next frame needs of a frame.</summary>
/// <param name="frame">The frame.</param>
/// <param name="surfaces">The surfaces that its picture shows.</param>
internal sealed class FlowMoment(FrameDraft frame, SurfaceMap surfaces)
{
    private readonly Dictionary<int, EntityState> _entities = frame
        .Snapshot.Entities.Concat(frame.Snapshot.Distant)
        .ToDictionary(static entity => entity.Handle);

    /// <summary>The frame.</summary>
    public FrameDraft Frame => frame;

    /// <summary>The surfaces that its picture shows.</summary>
    public SurfaceMap Surfaces => surfaces;

    /// <summary>How an entity moves from this moment to another one.</summary>
    /// <param name="other">The other moment.</param>
    /// <param name="handle">The entity's handle; not 0.</param>
    public BodyMotion MotionTo(FlowMoment other, int handle)
    {
        EgoState ego = frame.Snapshot.Ego;
        if (handle == ego.Handle)
        {
            EgoState there = other.Frame.Snapshot.Ego;
            return there.Handle == handle ? BodyMotion.Rigid(ego.Pose, there.Pose) : new BodyMotion(BodyMotionKind.Unknown);
        }

        if (
            !_entities.TryGetValue(handle, out EntityState? from)
            || !other._entities.TryGetValue(handle, out EntityState? to)
            || from.Model != to.Model
            || from.Class != to.Class
        )
        {
            return new BodyMotion(BodyMotionKind.Unknown);
        }

        // A rider sits on the vehicle and moves with it; another person moves the limbs.
        return from.VehicleHandle is { } vehicle && to.VehicleHandle == vehicle ? MotionTo(other, vehicle)
            : VehicleClasses.ArePeople(from.Class) ? new BodyMotion(BodyMotionKind.Person)
            : BodyMotion.Rigid(from.Pose, to.Pose);
    }
}
