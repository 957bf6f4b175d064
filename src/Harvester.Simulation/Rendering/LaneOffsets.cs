namespace Harvester.Simulation.Rendering;

/// <summary>
/// Where the corners of a triangle of asphalt lie across their road, counted in lanes: wheels wear the same places of every lane.
/// </summary>
/// <param name="A">Signed distance of the first corner from where the lanes are counted from, in widths of a lane.</param>
/// <param name="B">The same for the second corner.</param>
/// <param name="C">The same for the third corner.</param>
/// <param name="Inner">The distance from there at which the first lane begins: half the width of a median, in widths of a lane.</param>
/// <param name="Outer">The distance at which the last lane ends; 0 if there are no lanes.</param>
public readonly record struct LaneOffsets(float A, float B, float C, float Inner, float Outer);
