using Harvester.Geometry.Visibility;

namespace Harvester.Sessions.Scenes;

/// <summary>An entity beyond the labelling range, and whether it was seen.</summary>
/// <param name="Entity">The entity.</param>
/// <param name="Sight">Whether it was seen in the picture of its scene.</param>
public sealed record DistantEntity(EntityState Entity, Sight Sight);
