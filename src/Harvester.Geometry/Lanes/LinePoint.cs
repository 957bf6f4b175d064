namespace Harvester.Geometry.Lanes;

/// <summary>A point on the centre line of a painted line.</summary>
/// <param name="World">Metres, world.</param>
/// <param name="IsPainted">Whether there is paint at this point; false in the gap of a dashed line.</param>
public readonly record struct LinePoint(Vector3D World, bool IsPainted);
