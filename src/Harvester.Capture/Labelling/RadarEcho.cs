using Harvester.Geometry;

namespace Harvester.Capture.Labelling;

/// <summary>What a radar receives from one of its cells of angle and range.</summary>
/// <param name="Range">Distance of the nearest surface in the cell, metres.</param>
/// <param name="Direction">Unit direction to it, in the sensor's frame.</param>
/// <param name="Entity">The handle of the object; that of the world for surroundings.</param>
/// <param name="CrossSection">The cross-section of all that is in the cell, m².</param>
internal readonly record struct RadarEcho(double Range, Vector3D Direction, int Entity, double CrossSection);
