using System.Text.Json;
using Harvester.Geometry;

namespace Harvester.Simulation.Tests.Lanes;

/// <summary>A marking of a label line, as the line has it.</summary>
internal sealed class WrittenMarking(JsonElement marking)
{
    private readonly double[][] _points = Rows(marking, "points");
    private readonly double[][] _inCamera = Rows(marking, "inCamera");
    private readonly double[][] _pixels = Rows(marking, "pixels");
    private readonly bool[] _painted = [.. marking.GetProperty("painted").EnumerateArray().Select(item => item.GetBoolean())];
    private readonly bool[] _hidden = [.. marking.GetProperty("hidden").EnumerateArray().Select(item => item.GetBoolean())];

    public int Count => _points.Length;

    public bool IsYellow { get; } = marking.GetProperty("colour").GetString() == "yellow";

    public bool IsDouble { get; } = marking.GetProperty("style").GetString() == "doubleSolid";

    public double WidthMetres { get; } = marking.GetProperty("widthMetres").GetDouble();

    public bool IsPainted(int i) => _painted[i];

    /// <summary>Whether the points before and after it lie in the gap, too.</summary>
    public bool IsWithinGap(int i) => i > 0 && i + 1 < Count && !_painted[i - 1] && !_painted[i] && !_painted[i + 1];

    public bool IsHidden(int i) => _hidden[i];

    public double Depth(int i) => _inCamera[i][1];

    public Vector2D Pixel(int i) => new(_pixels[i][0], _pixels[i][1]);

    public Vector3D Point(int i) => new(_points[i][0], _points[i][1], _points[i][2]);

    /// <summary>Unit vector along the line on the ground.</summary>
    public Vector3D Along(int i)
    {
        Vector3D along = Point(Math.Min(i + 1, Count - 1)) - Point(Math.Max(i - 1, 0));
        return along * (1 / along.Length);
    }

    private static double[][] Rows(JsonElement marking, string name) =>
        [.. marking.GetProperty(name).EnumerateArray().Select(row => row.EnumerateArray().Select(number => number.GetDouble()).ToArray())];
}
