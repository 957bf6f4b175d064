using Harvester.Capture.Surveys;
using Harvester.Geometry.Paint;
using Harvester.Geometry.Roads;
using Harvester.Play.Surveys.Roads;

namespace Harvester.Play.Surveys.Paint;

/// <summary>A survey of paint that is ready to begin.</summary>
/// <param name="Plan">The pictures that are left.</param>
/// <param name="Earlier">Number of pictures of earlier surveys.</param>
public sealed record PreparedSurvey(StationPlan Plan, int Earlier)
{
    /// <summary>The folder of its session, which is not there yet.</summary>
    public string Folder { get; init; } = "";

    /// <summary>Reads the roads and the earlier pictures, and plans those that are left. It takes a while: for another thread.</summary>
    /// <param name="roadFile">The file of the roads.</param>
    /// <param name="folder">The folder of the sessions of all surveys of paint.</param>
    /// <param name="view">The camera.</param>
    /// <param name="area">Tells where the roads lie; null for all roads. It may read a file.</param>
    /// <exception cref="IOException">A file is missing or cannot be read; the message is for the player.</exception>
    /// <exception cref="FormatException">A file is damaged; the message is for the player.</exception>
    public static PreparedSurvey Of(string roadFile, string folder, SurveyView view, Func<SurveyArea?> area)
    {
        RoadNetwork network =
            RoadSurveyFile.Load(roadFile)
            ?? throw new FileNotFoundException(
                $"No roads are known: there is no {roadFile}. Survey the roads first, or name a road file under [Roads]."
            );
        SurveyArea? surveyed = (area ?? throw new ArgumentNullException(nameof(area)))();
        IReadOnlyList<SurveyStation> earlier = EarlierPictures.In(folder, view);
        var plan = StationPlan.Of(
            new PaintRoads(new RoadCurves(network)),
            (view ?? throw new ArgumentNullException(nameof(view))).Footprint,
            surveyed,
            earlier
        );
        return new PreparedSurvey(plan, earlier.Count);
    }
}
