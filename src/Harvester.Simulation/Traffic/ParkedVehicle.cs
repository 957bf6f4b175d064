using Harvester.Geometry;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Rendering;
using Harvester.Simulation.Streets;

namespace Harvester.Simulation.Traffic;

/// <summary>A parked vehicle that moves when it is struck.</summary>
internal sealed class ParkedVehicle(Prop prop)
{
    public Prop Prop { get; private set; } = prop;

    /// <summary>Null until it is struck.</summary>
    public Wreck? Wreck { get; set; }

    public Footprint Footprint { get; private set; } = Footprint.Of(prop.Pose, prop.Model.Min, prop.Model.Max);

    public MeshInstance Instance => new(Prop.Model.Variant(Prop.Variant), Prop.Pose, Prop.Handle);

    public EntityState State =>
        Wreck is { Body.Velocity: var velocity } ? Prop.State with { Velocity = new Vector3D(velocity.X, velocity.Y, 0) } : Prop.State;

    public void MoveTo(Pose pose)
    {
        Prop = Prop with { Pose = pose };
        Footprint = Footprint.Of(pose, Prop.Model.Min, Prop.Model.Max);
    }
}
