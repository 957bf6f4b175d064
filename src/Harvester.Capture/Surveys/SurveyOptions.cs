using Harvester.Capture.Harvesting;
using Harvester.Capture.Labelling;

namespace Harvester.Capture.Surveys;

/// <summary>The options of the harvest that a survey of paint is.</summary>
public static class SurveyOptions
{
    /// <summary>
    /// Labelling range, metres: no object is nearer to the camera, which is far above all. Hidden objects are in no picture, so they have
    /// no labels.
    /// </summary>
    private const double NoRange = 1;

    /// <summary>
    /// Rays of a picture: one through every sixteenth pixel of every sixteenth row and one between, and as many again where walls and trees
    /// meet the ground.
    /// </summary>
    private const int Rays = 24_000;

    /// <summary>Options that take one picture without objects at each place, with a map of its depth;
    /// formats, disk and freezing are as in other harvests.</summary>
    /// <param name="usual">The options of other harvests.</param>
    /// <param name="view">The camera.</param>
    public static HarvestOptions Of(HarvestOptions usual, SurveyView view) =>
        (usual ?? throw new ArgumentNullException(nameof(usual))) with
        {
            Image = (view ?? throw new ArgumentNullException(nameof(view))).Camera.Image,
            Rig = null,
            Pairs = new PairOptions(),
            RangeMetres = NoRange,
            IgnoreRangeMetres = 0,
            Masks = true,
            MaskMethod = MaskMethod.Rays,
            Semantics = null,
            Channels = ChannelKeys.None,
            Depth = true,
            RayBudget = Rays,
            Motion = false,
            Freeze = true,
            ProbeLag = false,
            MaxFrames = null,
        };
}
