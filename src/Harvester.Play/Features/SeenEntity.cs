using Harvester.Geometry;
using Harvester.Geometry.Boxes;

namespace Harvester.Play.Features;

/// <summary>An entity as the overlay draws it.</summary>
/// <param name="Model">The facts of its model.</param>
/// <param name="Place">Its pose and scale.</param>
public readonly record struct SeenEntity(ModelFacts Model, ScaledPose Place)
{
    /// <summary>The box around it.</summary>
    public Cuboid Cuboid => Cuboid.FromModel(Place.Stretch(Model.Min), Place.Stretch(Model.Max), Place.Pose);
}
