using Harvester.Geometry;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Models;

namespace Harvester.Simulation.Streets;

/// <summary>Something that stands for good: a parked vehicle, a sign, a lamp, a tree, a building.</summary>
/// <param name="Handle">The entity's handle; 0 for what is no entity.</param>
/// <param name="Model">Its model.</param>
/// <param name="Variant">Which of the model's looks it has.</param>
/// <param name="Pose">Where it stands.</param>
internal sealed record Prop(int Handle, Model Model, int Variant, Pose Pose)
{
    public EntityState State => new(Handle, Model.Class, Model.Name, Pose, Model.Min, Model.Max, Vector3D.Zero);
}
