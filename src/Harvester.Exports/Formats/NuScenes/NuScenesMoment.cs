using Harvester.Geometry;

namespace Harvester.Exports.Formats.NuScenes;

/// <summary>The ego at one tick of a scene.</summary>
/// <param name="Timestamp">Time, microseconds.</param>
/// <param name="Reading">What its sensors report.</param>
/// <param name="Position">Its position, metres, global.</param>
internal sealed record NuScenesMoment(long Timestamp, EgoReading Reading, Vector3D Position);
