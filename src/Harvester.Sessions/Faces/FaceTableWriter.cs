using System.Globalization;
using Harvester.Sessions.Scenes;
using Harvester.Sessions.Text;

namespace Harvester.Sessions.Faces;

/// <summary>Writes a table of faces in the project's own format, with corners in millimetres.</summary>
public static class FaceTableWriter
{
    /// <summary>The text of the file.</summary>
    public static string Text(FaceTable table)
    {
        using var text = new StringWriter(CultureInfo.InvariantCulture);
        Write(table, text);
        return text.ToString();
    }

    /// <summary>Writes the header and all rows, ordered by model and face.</summary>
    public static void Write(FaceTable table, TextWriter text)
    {
        if (table is null)
        {
            throw new ArgumentNullException(nameof(table));
        }

        if (text is null)
        {
            throw new ArgumentNullException(nameof(text));
        }

        text.Write(FaceColumns.Header + "\n");
        foreach (ModelFace face in table.Faces)
        {
            string[] fields =
            [
                CsvFields.Quote(face.Model),
                face.Hash.ToString(CultureInfo.InvariantCulture),
                face.Class == ObjectClass.TrafficLight ? "trafficLight" : "sign",
                CsvFields.Quote(face.Name),
                CsvFields.Quote(face.MutcdCode),
                face.Number.ToString(CultureInfo.InvariantCulture),
                Metres(face.FrontUpperLeft.X),
                Metres(face.FrontUpperLeft.Y),
                Metres(face.FrontUpperLeft.Z),
                Metres(face.BackLowerRight.X),
                Metres(face.BackLowerRight.Y),
                Metres(face.BackLowerRight.Z),
                FacingText(face.Facing),
                ProvenanceText(face.Provenance),
                CsvFields.Quote(face.Source),
            ];
            text.Write(string.Join(",", fields) + "\n");
        }
    }

    private static string Metres(double value)
    {
        // Whole millimetres as an integer: the digits are the same in every runtime, and there is no negative zero.
        long millimetres = (long)Math.Round(value * 1000, MidpointRounding.AwayFromZero);
        string digits = Math.Abs(millimetres).ToString("0000", CultureInfo.InvariantCulture);
        int point = digits.Length - 3;
        return (millimetres < 0 ? "-" : string.Empty) + digits.Substring(0, point) + "." + digits.Substring(point);
    }

    private static string FacingText(Facing facing) =>
        facing switch
        {
            Facing.Front => "+y",
            Facing.Left => "-x",
            Facing.Right => "+x",
            _ => "-y",
        };

    private static string ProvenanceText(Provenance provenance) =>
        provenance switch
        {
            Provenance.Measured => "measured",
            Provenance.Derived => "derived",
            _ => "estimated",
        };
}
