using System.Globalization;
using Harvester.Capture.Harvesting;
using Harvester.Capture.Surveys;
using Harvester.Geometry;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Roads;
using Harvester.Play.Surveys.Paint;
using Harvester.Play.Tapes;
using Harvester.Sessions.Text;

namespace Harvester.Play.Settings;

/// <summary>The player's settings except the keys. The shipped settings file describes their meaning and range.</summary>
public sealed record PlayerSettings
{
    private const double MaxOffsetMetres = 20;

    /// <summary>The game's name of the test car's model.</summary>
    public required string CarModel { get; init; }

    /// <summary>The text of the test car's number plate.</summary>
    public required string CarPlate { get; init; }

    /// <summary>Vertical field of view of the mounted camera, degrees.</summary>
    public required double VerticalFovDegrees { get; init; }

    /// <summary>Position of the mounted camera relative to the vehicle's origin, in its frame, metres.</summary>
    public required Vector3D CameraOffset { get; init; }

    /// <summary>What to harvest and how.</summary>
    public required HarvestOptions Options { get; init; }

    /// <summary>The folder of the sessions, each in a folder of its own.</summary>
    public required string Folder { get; init; }

    /// <summary>The road file; null to survey the roads in the game.</summary>
    public required string? RoadFile { get; init; }

    /// <summary>The table of the paint measured on the roads of <see cref="RoadFile"/>; null without one, or without roads.</summary>
    public required string? PaintFile { get; init; }

    /// <summary>Whether the settings name a table of paint but no roads.</summary>
    public required bool HasPaintWithoutRoads { get; init; }

    /// <summary>Width of the lanes of an ordinary road, metres.</summary>
    public required double LaneWidthMetres { get; init; }

    /// <summary>Width of the lanes of a narrow road, metres.</summary>
    public required double NarrowLaneWidthMetres { get; init; }

    /// <summary>The settings of the lanes that a session records, so that they can be measured again in the same way.</summary>
    public IReadOnlyList<KeyValuePair<string, string>> LaneSettings =>
        [
            new("lookAhead", LookAhead.Thesis.ToString()),
            new("laneWidth", LaneWidthMetres.ToString(CultureInfo.InvariantCulture)),
            new("narrowLaneWidth", NarrowLaneWidthMetres.ToString(CultureInfo.InvariantCulture)),
            .. PaintFile is null ? [] : new KeyValuePair<string, string>[] { new("paint", Path.GetFileName(PaintFile)) },
        ];

    /// <summary>The file of the road survey.</summary>
    public required string SurveyFile { get; init; }

    /// <summary>Around what the survey of paint photographs roads.</summary>
    public required SurveyPlace PaintAround { get; init; }

    /// <summary>The survey of paint leaves out roads farther from there, metres; null for none.</summary>
    public required double? PaintRangeMetres { get; init; }

    /// <summary>Ground in a pixel of the survey of paint, metres.</summary>
    public required double PaintMetresPerPixel { get; init; }

    /// <summary>The bridge over which a client drives.</summary>
    public required BridgeSettings Bridge { get; init; }

    /// <summary>The plan to run; null without one.</summary>
    public required string? PlanFile { get; init; }

    /// <summary>Whether the plan begins without the key.</summary>
    public required bool StartsPlan { get; init; }

    /// <summary>The folder of the plans' sessions.</summary>
    public required string PlansFolder { get; init; }

    /// <summary>The folder with the player's measurements of signs and lights.</summary>
    public required string FacesFolder { get; init; }

    /// <summary>Whether the survey of signs takes photographs.</summary>
    public required bool TakesPhotographs { get; init; }

    /// <summary>Names of further models that the survey of signs measures, separated by commas.</summary>
    public required string FurtherModels { get; init; }

    /// <summary>Names of signs for marking by hand; empty for those of the table.</summary>
    public required string SignNames { get; init; }

    /// <summary>Whether the traffic lights are driven while a harvest runs.</summary>
    public required bool DrivesLights { get; init; }

    /// <summary>The meaning of the game's numbers for the states of lights.</summary>
    public required LightOrder LightOrder { get; init; }

    /// <summary>What is recorded on a tape.</summary>
    public required TapeOptions Tape { get; init; }

    /// <summary>Maximum time of the survey of signs per tick, milliseconds.</summary>
    public required double SurveyBudgetMilliseconds { get; init; }

    /// <summary>The settings of a file; missing and invalid values have their defaults.</summary>
    /// <param name="ini">The file.</param>
    /// <param name="modFolder">The folder to which relative paths refer.</param>
    /// <exception cref="ArgumentNullException"><paramref name="ini"/> is null.</exception>
    public static PlayerSettings Read(IniFile ini, string modFolder)
    {
        if (ini is null)
        {
            throw new ArgumentNullException(nameof(ini));
        }

        string pictures = Path.Combine(Environment.GetFolderPath(Environment.SpecialFolder.MyPictures), "GtaDataHarvester");
        string folder = PathOf(ini.Text("Harvest", "Folder", pictures));
        string roads = ini.Text("Roads", "File", string.Empty);
        string paint = ini.Text("Roads", "Paint", string.Empty);
        string plan = ini.Text("Plan", "File", string.Empty);
        return new PlayerSettings
        {
            CarModel = ini.Text("TestCar", "Model", "adder"),
            CarPlate = ini.Text("TestCar", "Plate", "HARVEST"),
            VerticalFovDegrees = ini.Number("Camera", "VerticalFov", 50, 1, 130),
            CameraOffset = new Vector3D(Offset("OffsetRight", 0), Offset("OffsetForward", 2), Offset("OffsetUp", 0.4)),
            Options = HarvestSettings.Read(ini),
            Folder = folder,
            RoadFile = roads.Length > 0 ? PathOf(roads) : null,
            PaintFile = paint.Length > 0 && roads.Length > 0 ? PathOf(paint) : null,
            HasPaintWithoutRoads = paint.Length > 0 && roads.Length == 0,
            LaneWidthMetres = ini.Number("Roads", "LaneWidth", RoadGeometry.LaneWidth, 2, 10),
            NarrowLaneWidthMetres = ini.Number("Roads", "NarrowLaneWidth", RoadGeometry.NarrowLaneWidth, 2, 10),
            SurveyFile = Path.Combine(folder, "roads.csv"),
            PaintAround = ini.Choice("PaintSurvey", "Around", SurveyPlace.Player, "Player or Plan"),
            PaintRangeMetres = ini.Number("PaintSurvey", "Range", 500, 0, 100_000) is > 0 and var range ? range : null,
            PaintMetresPerPixel = ini.Number("PaintSurvey", "MetresPerPixel", SurveyView.UsualMetresPerPixel, 0.02, 0.035),
            Bridge = BridgeSettings.Read(ini, Path.Combine(folder, "bridge"), PathOf),
            PlanFile = plan.Length > 0 ? PathOf(plan) : null,
            StartsPlan = ini.Choice("Plan", "Start", Switch.Off, "On or Off") == Switch.On,
            PlansFolder = Path.Combine(folder, "plans"),
            FacesFolder = Path.Combine(folder, "spaces"),
            TakesPhotographs = ini.Choice("Signs", "Photographs", Switch.On, "On or Off") == Switch.On,
            FurtherModels = ini.Text("Signs", "Models", string.Empty),
            SignNames = ini.Text("Signs", "Names", string.Empty),
            DrivesLights = ini.Choice("Harvest", "DriveLights", Switch.Off, "On or Off") == Switch.On,
            LightOrder = ini.Choice("Harvest", "LightOrder", LightOrder.GreenRedAmber, "GreenRedAmber or RedAmberGreen"),
            Tape = TapeOf(ini, folder),
            SurveyBudgetMilliseconds = ini.Number("Signs", "TickBudget", 8, 0.1, 1000),
        };

        string PathOf(string text) => Path.Combine(modFolder, Environment.ExpandEnvironmentVariables(text));

        double Offset(string name, double fallback) => ini.Number("Camera", name, fallback, -MaxOffsetMetres, MaxOffsetMetres);
    }

    private static TapeOptions TapeOf(IniFile ini, string folder) =>
        new(
            ini.Choice("Tape", "Record", TapeChoice.Off, "Off, Natives or NativesAndPictures"),
            ini.Number("Tape", "Minutes", 2, 0.1, 10),
            folder
        );
}
