using Harvester.Geometry;
using Harvester.Geometry.Boxes;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Labelling;

/// <summary>An entity that is in the image, with its number, before it is known how much of it is hidden.</summary>
internal sealed record LabelCandidate(EntityState Entity, ushort Id, Cuboid Cuboid, CuboidProjection Projection, Box2D Box, Box2D AmodalBox);
