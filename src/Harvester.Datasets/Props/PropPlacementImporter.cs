using System.Text.Json;
using Harvester.Geometry;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Json;
using Harvester.Sessions.Scenes;

namespace Harvester.Datasets.Props;

/// <summary>
/// Reads lists of props in the format of the public dumps: objects with Name, Position and Rotation (X, Y, Z in degrees).
/// </summary>
public static class PropPlacementImporter
{
    /// <summary>Largest size of a list, bytes; the public dump of all props of one kind has less than a tenth of it.</summary>
    private const int MaxBytes = 32 << 20;

    /// <summary>Reads a list of props.</summary>
    /// <exception cref="DatasetFormatException">The file is not a valid list; the message names the place.</exception>
    /// <exception cref="IOException">The file cannot be read.</exception>
    public static IReadOnlyList<PropPlacement> Import(string path)
    {
        string file = Path.GetFileName(path);
        try
        {
            using JsonDocument document = JsonInput.Parse(InputFile.ReadAllBytes(path, MaxBytes));
            return Read(document.RootElement, file);
        }
        catch (JsonException e)
        {
            throw new DatasetFormatException($"{file}: {JsonFault.InText(e)}", e);
        }
    }

    private static List<PropPlacement> Read(JsonElement root, string file)
    {
        if (root.ValueKind != JsonValueKind.Array)
        {
            throw new DatasetFormatException($"{file}: expected a list of props.");
        }

        var props = new List<PropPlacement>(root.GetArrayLength());
        foreach (JsonElement element in root.EnumerateArray())
        {
            try
            {
                var fields = new JsonFields(element);
                Vector3D rotation = Components(fields.Fields("Rotation"));
                props.Add(
                    new PropPlacement(
                        fields.Text("Name"),
                        Components(fields.Fields("Position")),
                        new EulerAngles(rotation.X, rotation.Y, rotation.Z)
                    )
                );
            }
            catch (DatasetFormatException e)
            {
                throw new DatasetFormatException($"{file}, prop {props.Count}: {e.Message}", e);
            }
        }

        return props;
    }

    private static Vector3D Components(JsonFields fields) => new(fields.Number("X"), fields.Number("Y"), fields.Number("Z"));
}
