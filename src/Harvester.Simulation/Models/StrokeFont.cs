using Harvester.Geometry;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Models;

/// <summary>Letters and digits made of straight strokes, for the faces of signs.</summary>
internal static class StrokeFont
{
    private const double Advance = 3.1;

    /// <summary>Writes a line of text on a face that looks towards -y, so that it reads from left to right along +x.</summary>
    /// <param name="builder">Receives the strokes.</param>
    /// <param name="text">Capital letters and digits of the font, and blanks.</param>
    /// <param name="centre">Centre of the line, slightly in front of the face.</param>
    /// <param name="height">Height of a letter, metres.</param>
    /// <param name="colour">Colour of the strokes.</param>
    public static void Write(MeshBuilder builder, string text, Vector3D centre, double height, Rgb colour)
    {
        double unit = height / StrokeGlyphs.Height;
        double left = centre.X - (((text.Length * Advance) - (Advance - StrokeGlyphs.Width)) * unit / 2);
        for (int i = 0; i < text.Length; i++)
        {
            var corner = new Vector3D(left + (i * Advance * unit), centre.Y, centre.Z - (height / 2));
            foreach (IReadOnlyList<(int Column, int Row)> stroke in StrokeGlyphs.StrokesOf(text[i])!)
            {
                Vector3D[] points = [.. stroke.Select(at => corner + (new Vector3D(at.Column, 0, at.Row) * unit))];
                for (int point = 1; point < points.Length; point++)
                {
                    AddStroke(builder, points[point - 1], points[point], unit * 0.35, colour);
                }
            }
        }
    }

    /// <summary>Adds a straight stroke on a face that looks towards -y, with square ends that extend by half of its breadth.</summary>
    public static void AddStroke(MeshBuilder builder, Vector3D from, Vector3D to, double halfBreadth, Rgb colour)
    {
        Vector3D along = (to - from).Normalized() * halfBreadth;
        var across = new Vector3D(-along.Z, 0, along.X);
        builder.AddQuad(from - along - across, from - along + across, to + along + across, to + along - across, colour);
    }
}
