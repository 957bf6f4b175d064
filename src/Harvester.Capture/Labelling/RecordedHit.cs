using Harvester.Geometry;

namespace Harvester.Capture.Labelling;

/// <summary>What a ray has hit.</summary>
/// <param name="Ray">The ray.</param>
/// <param name="Distance">Distance of the hit from the ray's origin, metres.</param>
/// <param name="Normal">Unit normal of the surface, world, to either side.</param>
/// <param name="Entity">Handle of the entity that was hit.</param>
internal readonly record struct RecordedHit(Ray Ray, double Distance, Vector3D Normal, int Entity);
