using System.Collections.Generic;
using System.Linq;
using Harvester.Geometry;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Models;

/// <summary>Letters and digits made of straight strokes, for the faces of signs.</summary>
internal static class StrokeFont
{
    private const double GridWidth = 2;
    private const double GridHeight = 4;
    private const double Advance = 3.1;

    /// <summary>
    /// Strokes through points of a grid, column 0 to 2 from the left and row 0 to 4 from the bottom; a bar lifts the pen.
    /// </summary>
    private static readonly Dictionary<char, string> Glyphs = new()
    {
        ['A'] = "00 03 14 23 20|02 22",
        ['B'] = "00 04 14 23 12 21 10 00|02 12",
        ['C'] = "24 04 00 20",
        ['D'] = "00 04 14 23 21 10 00",
        ['E'] = "24 04 00 20|02 22",
        ['G'] = "24 04 00 20 22 12",
        ['I'] = "14 10",
        ['K'] = "04 00|24 02 20",
        ['L'] = "04 00 20",
        ['M'] = "00 04 12 24 20",
        ['N'] = "00 04 20 24",
        ['O'] = "00 04 24 20 00",
        ['P'] = "00 04 24 22 02",
        ['R'] = "00 04 24 22 02|12 20",
        ['S'] = "24 04 02 22 20 00",
        ['T'] = "04 24|14 10",
        ['U'] = "04 00 20 24",
        ['X'] = "04 20|00 24",
        ['Y'] = "04 12 24|12 10",
        ['0'] = "00 04 24 20 00",
        ['1'] = "14 10",
        ['2'] = "04 24 22 02 00 20",
        ['3'] = "04 24 20 00|02 22",
        ['5'] = "24 04 02 22 20 00",
        ['6'] = "24 04 00 20 22 02",
    };

    /// <summary>Writes a line of text on a face that looks towards -y, so that it reads from left to right along +x.</summary>
    /// <param name="builder">Receives the strokes.</param>
    /// <param name="text">Capital letters and digits of the font, and blanks.</param>
    /// <param name="centre">Centre of the line, slightly in front of the face.</param>
    /// <param name="height">Height of a letter, metres.</param>
    /// <param name="colour">Colour of the strokes.</param>
    public static void Write(MeshBuilder builder, string text, Vector3D centre, double height, Rgb colour)
    {
        double unit = height / GridHeight;
        double left = centre.X - (((text.Length * Advance) - (Advance - GridWidth)) * unit / 2);
        for (int i = 0; i < text.Length; i++)
        {
            if (text[i] == ' ')
            {
                continue;
            }

            var corner = new Vector3D(left + (i * Advance * unit), centre.Y, centre.Z - (height / 2));
            foreach (string stroke in Glyphs[text[i]].Split('|'))
            {
                Vector3D[] points = stroke.Split(' ').Select(at => corner + (new Vector3D(at[0] - '0', 0, at[1] - '0') * unit)).ToArray();
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
