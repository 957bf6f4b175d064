using Harvester.Geometry;
using Harvester.Geometry.Boxes;

namespace Harvester.Play.Features;

/// <summary>An entity as the overlay draws it.</summary>
/// <param name="Model">What is known of its model.</param>
/// <param name="Place">Where it is.</param>
public readonly record struct SeenEntity(ModelFacts Model, ScaledPose Place)
{
    /// <summary>The box around it.</summary>
    public Cuboid Cuboid => Cuboid.FromModel(Place.Stretch(Model.Min), Place.Stretch(Model.Max), Place.Pose);
}
