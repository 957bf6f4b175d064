using Harvester.Geometry;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Models;

namespace Harvester.Simulation.Streets;

/// <summary>A fixed object: a parked vehicle, a sign, a lamp, a tree, a building.</summary>
/// <param name="Handle">The entity's handle; 0 for an object that is not an entity.</param>
/// <param name="Model">Its model.</param>
/// <param name="Variant">Number of the model's variant.</param>
/// <param name="Pose">Its pose.</param>
internal sealed record Prop(int Handle, Model Model, int Variant, Pose Pose)
{
    public EntityState State =>
        new(Handle, Model.Class, Model.Name, Pose, Model.Min, Model.Max, Vector3D.Zero)
        {
            HasRider = VehicleClasses.HaveRiders(Model.Class) ? false : null,
            Lights = VehicleClasses.AreVehicles(Model.Class) ? default(VehicleLights) : null,
        };
}
