using System;
using System.Globalization;
using System.IO;
using Harvester.Sessions.Scenes;
using Harvester.Sessions.Text;

namespace Harvester.Sessions.Faces;

/// <summary>Writes a table of spaces of interest in the project's own form; corners to the millimetre.</summary>
public static class SpaceTableWriter
{
    /// <summary>The text of the file.</summary>
    public static string Text(SpaceTable table)
    {
        using var text = new StringWriter(CultureInfo.InvariantCulture);
        Write(table, text);
        return text.ToString();
    }

    /// <summary>Writes the header and all rows, ordered by model and face.</summary>
    public static void Write(SpaceTable table, TextWriter text)
    {
        if (table is null)
        {
            throw new ArgumentNullException(nameof(table));
        }

        if (text is null)
        {
            throw new ArgumentNullException(nameof(text));
        }

        text.Write(SpaceColumns.Header + "\n");
        foreach (SpaceOfInterest space in table.Spaces)
        {
            string[] fields =
            [
                CsvFields.Quote(space.Model),
                space.Hash.ToString(CultureInfo.InvariantCulture),
                space.Class == ObjectClass.TrafficLight ? "trafficLight" : "sign",
                CsvFields.Quote(space.Name),
                CsvFields.Quote(space.MutcdCode),
                space.Face.ToString(CultureInfo.InvariantCulture),
                Metres(space.FrontUpperLeft.X),
                Metres(space.FrontUpperLeft.Y),
                Metres(space.FrontUpperLeft.Z),
                Metres(space.BackLowerRight.X),
                Metres(space.BackLowerRight.Y),
                Metres(space.BackLowerRight.Z),
                FacingText(space.Facing),
                ProvenanceText(space.Provenance),
                CsvFields.Quote(space.Source),
            ];
            text.Write(string.Join(",", fields) + "\n");
        }
    }

    private static string Metres(double value)
    {
        // Whole millimetres as an integer: the digits are the same in every runtime, and there is no minus zero.
        long millimetres = (long)Math.Round(value * 1000, MidpointRounding.AwayFromZero);
        string digits = Math.Abs(millimetres).ToString("0000", CultureInfo.InvariantCulture);
        int point = digits.Length - 3;
        return (millimetres < 0 ? "-" : string.Empty) + digits.Substring(0, point) + "." + digits.Substring(point);
    }

    private static string FacingText(Facing facing) => facing switch
    {
        Facing.Front => "+y",
        Facing.Left => "-x",
        Facing.Right => "+x",
        _ => "-y",
    };

    private static string ProvenanceText(Provenance provenance) => provenance switch
    {
        Provenance.Measured => "measured",
        Provenance.Derived => "derived",
        _ => "estimated",
    };
}
