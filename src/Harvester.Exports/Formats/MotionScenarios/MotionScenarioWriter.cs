using System.Globalization;
using System.Text;
using Harvester.Datasets.Files;
using Harvester.Datasets.Logs;
using Harvester.Datasets.Roads;
using Harvester.Geometry.Maps;
using Harvester.Sessions.Files;
using Harvester.Sessions.Reading;

namespace Harvester.Exports.Formats.MotionScenarios;

/// <summary>
/// Writes what moved at a place and its map as scenarios of 9 s, for programs that predict or simulate traffic. See
/// docs/exports/motion-scenarios.md.
/// </summary>
internal sealed class MotionScenarioWriter(ExportOptions options, bool isWomd) : IDatasetWriter
{
    /// <summary>The list of all frames.</summary>
    public const string Frames = "frames.csv";

    /// <summary>The columns of <see cref="Frames"/>.</summary>
    public const string FrameColumns = "split,sequence,session,frame,view,time_seconds,scenario,scenario_seconds";

    /// <summary>The list of the scenarios.</summary>
    public const string Scenarios = "scenarios.csv";

    /// <summary>The columns of <see cref="Scenarios"/>.</summary>
    public const string ScenarioColumns = "file,scenario,split,steps,measured_steps,tracks,lanes,lanes_with_light";

    /// <summary>The least number of moments a second: steps between frames that are farther apart are not interpolated.</summary>
    public const double MinRateHz = 1.5;

    private const string FramePart = "frames";
    private const string MomentPrefix = "moments ";
    private const string OtherViews = "other views";
    private const string LongPrefix = "long ";

    private (SessionReader Session, LaneMaps Maps)? _maps;

    /// <summary>Name of the file with the scenarios of a split in WOMD.</summary>
    public static string RecordsOf(string split) => $"{split}.tfrecord-00000-of-00001";

    public WrittenObjects Write(ExportFrame frame, FrameOutput output)
    {
        double seconds = frame.Label.TimeSeconds - frame.SequenceTimeSeconds;
        if (!(seconds >= 0))
        {
            throw frame.Problem("its time is before that of the first frame at its place.");
        }

        int window = ScenarioWindow.Of(seconds) ?? throw frame.Problem("its place lasts longer than scenarios can be numbered.");
        bool isFirstView = frame.Rig is not { } rig || frame.Label.View == rig.Cameras[0].Name;
        string scenario = isFirstView ? ScenarioWindow.Name(frame.SequenceIndex, window) : "";
        output.Part(
            FramePart,
            string.Join(
                ',',
                frame.Split,
                Numbers.Text(frame.SequenceIndex),
                Numbers.Text(frame.RecordingIndex),
                Numbers.Text(frame.Label.Frame),
                frame.Label.View ?? "",
                frame.Label.TimeSeconds.ToString("F4", CultureInfo.InvariantCulture),
                scenario,
                isFirstView ? (seconds - ScenarioWindow.TimeOf(window, 0)).ToString("F4", CultureInfo.InvariantCulture) : ""
            )
        );
        string staged = $"{frame.Name}.json";
        if (!isFirstView)
        {
            // A frame without a file would count as left out.
            output.StagedPart(OtherViews, staged, static _ => { });
            return default;
        }

        MotionMoment moment = MomentOf(frame, seconds);
        output.StagedPart(PartOf((frame.Split, scenario)), staged, stream => MotionPart.Write(stream, moment));
        foreach (int near in ScenarioWindow.WithStepsNear(seconds).Where(near => near != window))
        {
            output.Part(PartOf((frame.Split, ScenarioWindow.Name(frame.SequenceIndex, near))), $"{DatasetFolder.Staging}/{staged}");
        }

        if (ScenarioWindow.HasSecondStep(seconds, window))
        {
            output.Part($"{LongPrefix}{frame.Split}/{scenario}", "");
        }

        return default;
    }

    public IEnumerable<AggregateFile> Aggregates(IReadOnlyDictionary<string, int> parts)
    {
        (string Split, string Name)[] scenarios =
        [
            .. parts
                .Keys.Where(part => part.StartsWith(LongPrefix, StringComparison.Ordinal))
                .Select(part => part[LongPrefix.Length..].Split('/'))
                .Select(path => (path[0], path[1])),
        ];
        return (
            isWomd
                ? scenarios
                    .GroupBy(scenario => scenario.Split)
                    .Select(split => new AggregateFile(
                        RecordsOf(split.Key),
                        [.. split.Select(scenario => Record(scenario, RecordsOf(split.Key)))]
                    ))
                : scenarios.Select(scenario => new AggregateFile(FileOf(scenario), [Record(scenario, FileOf(scenario))]))
        )
            .Append(new AggregateFile(Frames, [AggregateSection.Literal(FrameColumns + "\n"), AggregateSection.Lines(FramePart)]))
            .Append(
                new AggregateFile(
                    Scenarios,
                    [
                        AggregateSection.Literal(ScenarioColumns + "\n"),
                        .. scenarios.Select(scenario =>
                            AggregateSection.Container(
                                PartOf(scenario),
                                (stream, moments) =>
                                    stream.Write(Encoding.ASCII.GetBytes(Row(ScenarioAssembly.Of(scenario.Name, moments), scenario.Split)))
                            )
                        ),
                    ]
                )
            );
    }

    private static string PartOf((string Split, string Name) scenario) => $"{MomentPrefix}{scenario.Split}/{scenario.Name}";

    private static string FileOf((string Split, string Name) scenario) => $"{scenario.Split}/{scenario.Name}.json";

    private AggregateSection Record((string Split, string Name) scenario, string file) =>
        AggregateSection.Container(
            PartOf(scenario),
            (stream, moments) =>
            {
                AssembledScenario assembled = ScenarioAssembly.Of(scenario.Name, moments);
                if (isWomd)
                {
                    TfRecord.Write(stream, WomdScenario.Bytes(assembled.Log));
                }
                else
                {
                    GpuDriveScenario.Write(stream, assembled.Log, Path.GetFileName(file), assembled.Measured);
                }
            }
        );

    private string Row(AssembledScenario scenario, string split) =>
        string.Join(
            ',',
            isWomd ? RecordsOf(split) : FileOf((split, scenario.Log.Id)),
            scenario.Log.Id,
            split,
            Numbers.Text(scenario.Log.Times.Count),
            Numbers.Text(scenario.Measured.Count(isMeasured => isMeasured)),
            Numbers.Text(scenario.Log.Tracks.Count),
            Numbers.Text(scenario.Log.Features.Count(feature => feature.Kind == LogFeatureKind.Lane)),
            Numbers.Text(scenario.Log.Signals.SelectMany(step => step).Select(signal => signal.Lane).Distinct().Count())
        ) + "\n";

    private MotionMoment MomentOf(ExportFrame frame, double seconds)
    {
        // The map reaches farther than a car drives in a second; all frames would have it many times.
        int every = Math.Max(1, (int)Math.Ceiling(frame.RateHz));
        NamedFeature[] features =
            frame.FrameInSequence % every != 0
                ? []
                :
                [
                    .. MotionMap.Of(
                        MapsOf(frame).Around(frame.Label.Ego.Position)
                            ?? throw frame.Problem("more roads meet around it than a map of lanes takes."),
                        frame.Label
                    ),
                ];
        return new MotionMoment(
            seconds,
            [
                .. MotionActors.Of(
                    frame.Scene ?? throw frame.Problem("it has no scene, which has all that moves around it. Harvest without --no-scenes.")
                ),
            ],
            MotionLights.Of(frame.Label),
            features
        );
    }

    private LaneMaps MapsOf(ExportFrame frame)
    {
        if (_maps is not { } known || known.Session != frame.Session)
        {
            LaneMaps maps = SessionLanes.Of(frame.Session, options.Roads) ?? throw frame.Problem($"its session has no {FramePaths.Roads}.");
            _maps = known = (frame.Session, maps);
        }

        return known.Maps;
    }
}
