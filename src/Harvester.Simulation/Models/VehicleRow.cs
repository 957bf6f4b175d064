using System.Globalization;
using Harvester.Geometry;
using Harvester.Sessions.Scenes;

namespace Harvester.Simulation.Models;

/// <summary>A vehicle of the game with the size of its model, from the embedded list.</summary>
internal sealed record VehicleRow(string Model, ObjectClass Class, VehicleShape Shape, Vector3D Min, Vector3D Max)
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
            new(Number(cells[6]), Number(cells[7]), Number(cells[8]))
        );

    private static double Number(string cell) => double.Parse(cell, CultureInfo.InvariantCulture);
}
