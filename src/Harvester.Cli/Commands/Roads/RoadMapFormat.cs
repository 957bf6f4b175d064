using System.IO.Compression;
using Harvester.Cli.Arguments;
using Harvester.Exports.Maps;
using Harvester.Reports.Maps;
using Harvester.Runs.Faults;
using Harvester.Sessions.Imaging.Pictures;

namespace Harvester.Cli.Commands.Roads;

/// <summary>What roads map writes: an image, or the lanes in a format of maps.</summary>
/// <param name="Name">Name on the command line.</param>
/// <param name="Ending">How names of its files end, with the dot.</param>
/// <param name="Description">What it is.</param>
/// <param name="WriteImage">Writes the image; null for lanes.</param>
/// <param name="Lanes">The format of the lanes; null for an image.</param>
internal sealed record RoadMapFormat(string Name, string Ending, string Description, Action<RoadMap, Stream>? WriteImage, MapFormat? Lanes)
{
    /// <summary>All of them.</summary>
    public static IReadOnlyList<RoadMapFormat> All { get; } =
    [
        new("png", ".png", "an image", static (map, stream) => new PngEncoder(CompressionLevel.Optimal).Write(map.Draw(), stream), null),
        new("svg", ".svg", "a drawing", static (map, stream) => map.WriteSvg(stream), null),
        .. MapFormats.All.Select(format => new RoadMapFormat(format.Name, format.Ending, format.Description, null, format)),
    ];

    /// <summary>The formats as lines of a help.</summary>
    public static string Help => string.Concat(All.Select(format => $"  {format.Name, -12}{format.Ending, -10}{format.Description}\n"));

    /// <summary>The endings as a list.</summary>
    public static string Endings => ValueParsers.Listed([.. All.Select(format => format.Ending).Distinct()]);

    /// <summary>The format of the files that end as a file does.</summary>
    /// <exception cref="UsageException">No format has this ending, or several.</exception>
    public static RoadMapFormat OfFile(string file)
    {
        RoadMapFormat[] found = [.. All.Where(format => Path.GetExtension(file).Equals(format.Ending, StringComparison.OrdinalIgnoreCase))];
        return found.Length switch
        {
            1 => found[0],
            0 => throw new UsageException($"--out takes a file that ends in {Endings}; or name a --format."),
            _ => throw new UsageException(
                $"A file that ends in {found[0].Ending} can be of several formats: name "
                    + $"{ValueParsers.Listed([.. found.Select(format => "--format " + format.Name)])}."
            ),
        };
    }
}
