using System.CommandLine;
using System.Globalization;
using Harvester.Cli.Terminals;
using Harvester.Datasets.Files;
using Harvester.Datasets.Logs;
using Harvester.Datasets.Roads;
using Harvester.Exports.Formats.MotionScenarios;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Text;

namespace Harvester.Cli.Commands.Logs;

/// <summary>harvester log import: makes roads and traffic of scenarios of GPUDrive or WOMD.</summary>
internal static class LogImportCommand
{
    /// <summary>The examples in the help.</summary>
    public const string Examples =
        "Examples:\n"
        + "  harvester log import scenario.json --out logs\n"
        + "  harvester log import training.tfrecord-00000-of-01000 --out logs";

    private const string Notes =
        "FILE is a scenario of GPUDrive (.json) or a file of the Waymo Open Motion Dataset, which may have many. Each scenario becomes a\n"
        + "folder in DIR, numbered from 0000, with roads.csv, made of its lanes, and traffic.json, what moved and the lights. Folders of\n"
        + "the same numbers are replaced. docs/logs.md has the format, what is left out and the limits.\n\n"
        + Examples;

    /// <summary>Folders are numbered with four digits.</summary>
    private const int MaxScenarios = 10_000;

    public static Command Create(Terminal terminal)
    {
        var files = new Argument<FileInfo[]>("FILE") { Description = "Files of scenarios", Arity = ArgumentArity.OneOrMore };
        var output = new Option<string>("--out")
        {
            Description = "Folder to write to",
            HelpName = "DIR",
            Required = true,
        };
        var command = new Command("import", "Make roads and traffic of recorded scenarios.") { files, output };
        HelpWithNotes.AddTo(command, Notes);
        command.SetAction(
            (parsed, cancellation) =>
                Task.FromResult(Import(terminal, parsed.GetRequiredValue(files), parsed.GetRequiredValue(output), cancellation))
        );
        return command;
    }

    private static int Import(Terminal terminal, FileInfo[] files, string folder, CancellationToken cancellation)
    {
        int number = 0;
        foreach (FileInfo file in files)
        {
            foreach (LogReading reading in Read(file.FullName))
            {
                cancellation.ThrowIfCancellationRequested();
                if (number == MaxScenarios)
                {
                    throw new DatasetFormatException($"{file.FullName}: there are more than {MaxScenarios} scenarios, the limit.");
                }

                string to = Path.Combine(folder, number++.ToString("D4", CultureInfo.InvariantCulture));
                terminal.Out.WriteLine($"{to}: {Write(reading, to, file)}");
            }
        }

        if (number == 0)
        {
            throw new DatasetFormatException($"{files[0].FullName}: it has no scenario.");
        }

        return ExitCode.Done;
    }

    private static IEnumerable<LogReading> Read(string path)
    {
        using IEnumerator<LogReading> scenarios = (
            path.EndsWith(".json", StringComparison.OrdinalIgnoreCase) ? GpuDriveReader.ReadAll(path) : WomdReader.Read(path)
        ).GetEnumerator();
        while (true)
        {
            try
            {
                if (!scenarios.MoveNext())
                {
                    yield break;
                }
            }
            catch (DatasetFormatException e)
            {
                throw new DatasetFormatException($"{path}: {e.Message}", e);
            }

            yield return scenarios.Current;
        }
    }

    private static string Write(LogReading reading, string folder, FileInfo file)
    {
        LogRoads roads = LogRoads.Of(reading.Log);
        if (roads.Lanes == 0)
        {
            throw new DatasetFormatException($"{file.FullName}: scenario '{reading.Log.Id}' has no lanes, of which roads could be made.");
        }

        Directory.CreateDirectory(folder);
        RoadWriter.Write(roads.Network, Path.Combine(folder, TrafficFile.Roads));
        OutputFile.Write(Path.Combine(folder, TrafficFile.Name), stream => TrafficFile.Write(stream, reading.Log, file.Name));
        double[] deviations = roads.Deviations();
        int lights = reading.Log.Signals.SelectMany(step => step).Select(signal => signal.Lane).Distinct().Count();
        string[] leftOut =
        [
            .. reading.LeftOut.Select(count => $"{count.Value} {count.Key}"),
            .. roads.BicycleLanes > 0 ? [Counted.Of(roads.BicycleLanes, "bicycle lane")] : Array.Empty<string>(),
            .. roads.ShortLanes > 0 ? [Counted.Of(roads.ShortLanes, "short lane")] : Array.Empty<string>(),
        ];
        const double share = 0.95;
        double within = deviations[(int)(share * (deviations.Length - 1))];
        string lanes = Counted.Of(roads.Lanes, "lane");
        return string.Create(
                CultureInfo.InvariantCulture,
                $"{Counted.Of(reading.Log.Tracks.Count, "track")}, {Counted.Of(reading.Log.Times.Count, "step")}, {lanes} "
            )
            + string.Create(
                CultureInfo.InvariantCulture,
                $"({share:P0} of their points within {within:0.000} m of the roads' middles, all within "
            )
            + string.Create(CultureInfo.InvariantCulture, $"{deviations[^1]:0.000} m), {Counted.Of(lights, "lane")} with lights")
            + (leftOut.Length > 0 ? $"; left out: {string.Join(", ", leftOut)}" : "");
    }
}
