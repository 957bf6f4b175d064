using Harvester.Geometry.PixelMaps;
using Harvester.Sessions.Imaging.Pictures;
using Harvester.Sessions.Reading.Json;
using Harvester.Sessions.Semantics;
using Harvester.Sessions.Text;

namespace Harvester.Exports.Formats.Semantic;

/// <summary>
/// Writes the class map of each frame as a PNG with a palette, so that it is both readable as numbers and visible as colours, and a mask of
/// the drivable area. See docs/exports/semantic.md.
/// </summary>
internal sealed class SemanticWriter : IDatasetWriter
{
    /// <summary>The value of the drivable area in its masks: white in any viewer.</summary>
    public const ushort Drivable = 255;

    private readonly PngEncoder _png = new();

    /// <summary>The colours of the classes, by value.</summary>
    public static IReadOnlyList<(byte Red, byte Green, byte Blue)> Palette { get; } =
    [.. Enum.GetValues<SemanticClass>().Select(SemanticClasses.ColourOf)];

    public WrittenObjects Write(ExportFrame frame, FrameOutput output)
    {
        InstanceMap classes = frame.Classes!;
        output.Image($"images/{frame.Split}/{frame.Name}{frame.ImageExtension}", frame);
        output.File($"classes/{frame.Split}/{frame.Name}.png", stream => _png.WriteIndexed(classes, Palette, stream));
        output.File($"drivable/{frame.Split}/{frame.Name}.png", stream => _png.WriteGrey8(DrivableIn(classes), stream));
        return new WrittenObjects(0);
    }

    public IEnumerable<AggregateFile> Aggregates(IReadOnlyDictionary<string, int> parts) =>
        [new AggregateFile("classes.json", [AggregateSection.Literal(ClassList() + "\n")])];

    /// <summary>The mask of what a car may drive on: roads and the markings on them.</summary>
    public static InstanceMap DrivableIn(InstanceMap classes)
    {
        var mask = new InstanceMap(classes.Image);
        for (int i = 0; i < mask.Ids.Length; i++)
        {
            mask.Ids[i] = (SemanticClass)classes.Ids[i] is SemanticClass.Road or SemanticClass.LaneMarking ? Drivable : (ushort)0;
        }

        return mask;
    }

    private static string ClassList() =>
        JsonLine.Of(json =>
        {
            json.WriteStartArray();
            foreach (SemanticClass kind in Enum.GetValues<SemanticClass>())
            {
                (byte red, byte green, byte blue) = SemanticClasses.ColourOf(kind);
                json.WriteStartObject();
                json.WriteNumber("id", (int)kind);
                json.WriteString("name", JsonName.Of(kind));
                json.WriteStartArray("colour");
                json.WriteNumberValue(red);
                json.WriteNumberValue(green);
                json.WriteNumberValue(blue);
                json.WriteEndArray();
                json.WriteEndObject();
            }

            json.WriteEndArray();
        });
}
