using System.CommandLine;
using System.Globalization;
using Harvester.Capture.Labelling;
using Harvester.Runs.Faults;
using Harvester.Sessions.Reading;
using Harvester.Simulation.Settings;

namespace Harvester.Cli.Arguments;

/// <summary>The options that set how much happens in a simulated world.</summary>
internal sealed class VarietyOptions
{
    private const int UsualPlaces = 10;
    private const int UsualFramesOfPlace = 10;
    private const int MaxPlaces = 10_000;
    private const double MaxWander = 3;
    private const double MaxLaneChanges = 5;
    private const double MaxTraffic = 4;
    private const double MaxPedestrians = 5;
    private const double MaxParked = 2.5;

    private readonly Option<double> _wander = Factor("--wander", "how far and how often the car leaves the middle of its lane", MaxWander);
    private readonly Option<double> _laneChanges = Factor("--lane-changes", "the number of lane changes and overtakings", MaxLaneChanges);
    private readonly Option<double> _traffic = Factor("--traffic", "the number of moving vehicles", MaxTraffic);
    private readonly Option<double> _pedestrians = Factor("--pedestrians", "the number of people on foot", MaxPedestrians);
    private readonly Option<double> _parked = Factor("--parked", "the number of parked vehicles", MaxParked);

    private readonly Option<int?> _places = ValueParsers.Optional<int>(
        "--places",
        "N",
        "Number of places to visit, all over the road network [default: 10; fewer for less than 100 frames; 1 with --near]",
        text => NumberText.Read(text) is >= 1 and <= MaxPlaces and var places && places == Math.Floor(places) ? (int)places : null,
        $"a whole number from 1 to {MaxPlaces}"
    );

    private readonly Option<bool> _variedRoads = new("--varied-roads")
    {
        Description = "Draw lane widths, edge lines and paint at random for each road, by the seed",
    };

    private readonly Option<double> _paintWear = ValueParsers.Number(
        "--paint-wear",
        "F",
        "Wear of the road paint, from 0 (new) to 1 (half of it missing, the rest faded)",
        value => value is >= 0 and <= 1,
        "a number from 0 to 1"
    );

    private readonly Option<bool> _crashes = new("--crashes")
    {
        Description = "Let vehicles brake only as hard as tyres allow, and collide; otherwise they stop at once before they touch",
    };

    /// <summary>Adds the options to a command.</summary>
    public void AddTo(Command command)
    {
        foreach (
            Option option in new Option[]
            {
                _places,
                _wander,
                _laneChanges,
                _traffic,
                _pedestrians,
                _parked,
                _variedRoads,
                _paintWear,
                _crashes,
            }
        )
        {
            command.Options.Add(option);
        }
    }

    /// <summary>The places of a harvest.</summary>
    /// <param name="parsed">The command line.</param>
    /// <param name="frames">Number of frames.</param>
    /// <param name="isNear">Whether the place to start from is given.</param>
    /// <exception cref="UsageException">There are more places than frames.</exception>
    public PlaceSequence Places(ParseResult parsed, int frames, bool isNear)
    {
        int usual = isNear ? 1 : Math.Clamp(frames / UsualFramesOfPlace, 1, UsualPlaces);
        int places = parsed.GetValue(_places) ?? usual;
        return places <= frames
            ? new PlaceSequence(frames, places)
            : throw new UsageException($"--places {places} needs at least as many --frames, not {frames}.");
    }

    /// <summary>Options of a simulation with the given factors; all others have their defaults.</summary>
    public SimulationOptions Parse(ParseResult parsed) =>
        new()
        {
            Wander = parsed.GetValue(_wander),
            LaneChanges = parsed.GetValue(_laneChanges),
            TrafficDensity = parsed.GetValue(_traffic),
            PedestrianDensity = parsed.GetValue(_pedestrians),
            ParkedDensity = parsed.GetValue(_parked),
            HasVariedRoads = parsed.GetValue(_variedRoads),
            PaintWear = parsed.GetValue(_paintWear),
            HasCrashes = parsed.GetValue(_crashes),
        };

    private static Option<double> Factor(string name, string what, double most)
    {
        Option<double> option = ValueParsers.Number(
            name,
            "F",
            $"Factor on {what}; 0 for none",
            value => value >= 0 && value <= most,
            string.Create(CultureInfo.InvariantCulture, $"a number from 0 to {most}")
        );
        option.DefaultValueFactory = _ => 1;
        return option;
    }
}
