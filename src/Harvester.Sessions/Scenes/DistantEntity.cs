using Harvester.Geometry.Visibility;

namespace Harvester.Sessions.Scenes;

/// <summary>An entity beyond the labelling range, and whether it was visible.</summary>
/// <param name="Entity">The entity.</param>
/// <param name="Sight">Whether it was visible in the image of its scene.</param>
public sealed record DistantEntity(EntityState Entity, Sight Sight);
