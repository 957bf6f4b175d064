using System.Globalization;
using Harvester.Geometry;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Models;

/// <summary>A vehicle of the game with the size of its model, from the embedded list.</summary>
/// <param name="Model">The model's name.</param>
/// <param name="Class">Its class in labels.</param>
/// <param name="Shape">What its mesh is made after.</param>
/// <param name="Min">Rear, left, lower corner in the model's frame, metres.</param>
/// <param name="Max">Front, right, upper corner in the model's frame, metres.</param>
/// <param name="Paint">The only colour of the model; null for those of its kind.</param>
internal sealed record VehicleRow(string Model, ObjectClass Class, VehicleShape Shape, Vector3D Min, Vector3D Max, Rgb? Paint)
{
    private const string Resource = "vehicles.csv";

    public static IEnumerable<VehicleRow> ReadAll()
    {
        using Stream stream =
            typeof(VehicleRow).Assembly.GetManifestResourceStream(Resource)
            ?? throw new InvalidOperationException($"The embedded list {Resource} is missing.");
        using var reader = new StreamReader(stream);
        _ = reader.ReadLine();
        while (reader.ReadLine() is { } line)
        {
            yield return Parse(line.Split(','));
        }
    }

    private static VehicleRow Parse(string[] cells) =>
        new(
            cells[0],
            Enum.Parse<ObjectClass>(cells[1]),
            Enum.Parse<VehicleShape>(cells[2]),
            new(Number(cells[3]), Number(cells[4]), Number(cells[5])),
            new(Number(cells[6]), Number(cells[7]), Number(cells[8])),
            cells[9].Length > 0 ? Colour(cells[9]) : null
        );

    /// <summary>A colour as in HTML: #RRGGBB.</summary>
    private static Rgb Colour(string cell)
    {
        int number = int.Parse(cell.AsSpan(1), NumberStyles.HexNumber, CultureInfo.InvariantCulture);
        return new Rgb((byte)(number >> 16), (byte)(number >> 8), (byte)number);
    }

    private static double Number(string cell) => double.Parse(cell, CultureInfo.InvariantCulture);
}
