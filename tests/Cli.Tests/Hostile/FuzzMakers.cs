using Harvester.Exports.Formats;
using Harvester.Sessions.Labels;

namespace Harvester.Cli.Tests.Hostile;

/// <summary>Commands that make the files of the corpus.</summary>
internal static class FuzzMakers
{
    /// <summary>Make the datasets of the corpus, and a session that shows people with joints; {0} is its folder.</summary>
    public static IReadOnlyList<string> All { get; } =
    [
        "harvest --out {0}/people --frames 1 --pedestrians 5 --roads {0}/straight.csv --seed 2 --size 64x48 --masks --no-report",
        .. "coco-keypoints jta".Split(' ').Select(format => $"export {{0}}/people --format {format} --out {{0}}/{format}"),
        .. DatasetFormats
            .All.Where(format => !format.HasMap && format.Program is null && format.Name is not ("coco-keypoints" or "jta"))
            .Select(format => $"export {{0}}/session --format {format.Name} --out {{0}}/{format.Name}"),
        "counterfactual --out {0}/set --frames 2 --places 1 --change frame_0:_weather_rain --roads {0}/straight.csv --size 64x48 "
            + "--no-report",
        "harvest --out {0}/moving --frames 2 --hz 10 --places 1 --roads {0}/straight.csv --seed 5 --size 64x48 --no-report",
        .. DatasetFormats
            .All.Where(format => format.HasMap)
            .Select(format => $"export {{0}}/moving --format {format.Name} --roads {{0}}/straight.csv --out {{0}}/{format.Name}"),
        "harvest --out {0}/eventful --frames 2 --hz 10 --places 1 --events --roads {0}/straight.csv --seed 5 --size 64x48 --no-report",
        "log import {0}/gpudrive/train/0000_0000.json --out {0}/logs",
    ];

    /// <summary>The options with which a harvest has the files of all channels that are switched on by their names.</summary>
    public static string MapOptions { get; } =
        string.Join(" ", FrameChannels.All.Select(channel => channel.Switch?.Option).OfType<string>());
}
