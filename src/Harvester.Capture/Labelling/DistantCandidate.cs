using Harvester.Geometry;
using Harvester.Geometry.Boxes;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Labelling;

/// <summary>An entity beyond the labelling range that is in the image, before its visibility is known.</summary>
/// <param name="Entity">The entity.</param>
/// <param name="Cuboid">Its cuboid in the world.</param>
/// <param name="Projection">The cuboid's projection.</param>
/// <param name="Box">The box around its part inside the image.</param>
internal sealed record DistantCandidate(EntityState Entity, Cuboid Cuboid, CuboidProjection Projection, Box2D Box);
