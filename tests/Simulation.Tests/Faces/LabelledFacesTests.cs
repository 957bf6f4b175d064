using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;
using Harvester.TestSupport;

namespace Harvester.Simulation.Tests.Faces;

/// <summary>Faces of labels against the faces that the pictures truly show.</summary>
public sealed class LabelledFacesTests
{
    /// <summary>The required precision and recall.</summary>
    private const double MinFraction = 0.98;

    /// <summary>The required accuracy of the states of lights.</summary>
    private const double MinCorrect = 0.99;

    /// <summary>Faces of less than the smallest box that is labelled are slivers: neither wanted nor wrong.</summary>
    private const int SliverPixels = 16;

    /// <summary>A label is of the face at its place; a session's numbers are rounded nowhere before the file.</summary>
    private const double SamePlaceMetres = 1e-9;
    private const double MinHeadPixels = 12;
    private const double MaxHidden = 0.05;

    /// <summary>The turn up to which the project wants lights read.</summary>
    private const double ReadUpToDegrees = 60;

    /// <summary>The truth is that of a head's front: another thing may hide a side of its housing and nothing of that.</summary>
    private const double MaxBeside = 0.02;

    /// <summary>Of a head at the border of what can be read the lens is so small that its lamp may not stand out.</summary>
    private const double MaxUnread = 0.02;

    [Fact]
    [Trait("Category", "Heavy")]
    public void Labelled_faces_are_the_visible_ones_with_their_light_states()
    {
        int frames = ProofSize.Of(inCi: 200, full: 1_000);
        Judge(StreetOfFaces.Harvest(frames, firstSeed: 1_000), minFaces: 5 * frames, minHeads: frames / 2);
    }

    [Fact]
    public void Lights_that_the_harvester_drives_are_labelled_as_set()
    {
        int heads = 0;
        foreach ((FrameLabel label, IReadOnlyList<TrueFace> faces) in StreetOfFaces.Harvest(3, firstSeed: 1, setsLights: true))
        {
            foreach (ObjectLabel head in label.Objects.Where(label => label.Face?.Light is not null))
            {
                Assert.Equal(new LightLabel(TruthOf(head, faces).State!.Value, LightMethod.Set, null), head.Face!.Light);
                heads++;
            }
        }

        Assert.True(heads > 5, $"Only {heads} heads.");
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Heads_hidden_only_by_their_own_model_are_visible_and_read()
    {
        int heads = 0,
            hidden = 0,
            unknown = 0;
        foreach ((FrameLabel label, IReadOnlyList<TrueFace> faces) in StreetOfFaces.Harvest(40, firstSeed: 400))
        {
            foreach (
                ObjectLabel head in label.Objects.Where(item =>
                    item.Face is { Light: not null, FacingAngleDegrees: <= ReadUpToDegrees }
                    && item.Box2D.Height >= MinHeadPixels
                    && item.TruncatedFraction == 0
                )
            )
            {
                TrueFace truth = TruthOf(head, faces);
                if (truth.VisiblePixels == truth.PixelsAlone.Value)
                {
                    heads++;
                    hidden += head.OccludedFraction > MaxHidden ? 1 : 0;
                    unknown += head.Face!.Light!.State == LightState.Unknown ? 1 : 0;
                }
            }
        }

        string figures = $"{heads} heads, {hidden} of them hidden, {unknown} unknown";
        Assert.True(heads > 100, figures);
        Assert.True(hidden <= MaxBeside * heads && unknown <= MaxUnread * heads, figures);
    }

    private static void Judge(IEnumerable<(FrameLabel Label, IReadOnlyList<TrueFace> Faces)> frames, int minFaces, int minHeads)
    {
        int right = 0,
            wrong = 0,
            missed = 0,
            fromBehind = 0,
            statesRight = 0,
            statesWrong = 0;
        foreach ((FrameLabel label, IReadOnlyList<TrueFace> faces) in frames)
        {
            fromBehind += label.Objects.Count(item =>
                item is { Class: ObjectClass.Sign, Face: not null } && !TruthOf(item, faces).FacesCamera
            );
            ObjectLabel[] labelled =
            [
                .. label.Objects.Where(item => item.Face is not null && (item.Class == ObjectClass.Sign || item.Face.FacesCamera)),
            ];
            foreach (ObjectLabel item in labelled)
            {
                TrueFace truth = TruthOf(item, faces);
                right += truth.FacesCamera && truth.VisiblePixels > 0 ? 1 : 0;
                wrong += truth.FacesCamera && truth.VisiblePixels > 0 ? 0 : 1;
                if (item.Class == ObjectClass.TrafficLight && IsClear(item))
                {
                    bool isRight = item.Face!.Light!.State == truth.State;
                    statesRight += isRight ? 1 : 0;
                    statesWrong += isRight ? 0 : 1;
                }
            }

            missed += faces.Count(face =>
                face.FacesCamera
                && face.VisiblePixels >= SliverPixels
                && !labelled.Any(item => (item.Box3D.Centre - face.Centre).Length < SamePlaceMetres)
            );
        }

        string figures =
            $"right {right}, wrong {wrong}, missed {missed}, signs from behind {fromBehind}; states right {statesRight}, wrong "
            + $"{statesWrong}";
        Assert.True(right >= minFaces && statesRight >= minHeads, figures);
        Assert.True(fromBehind == 0, figures);
        Assert.True(right >= MinFraction * (right + wrong), figures);
        Assert.True(right >= MinFraction * (right + missed), figures);
        Assert.True(statesRight >= MinCorrect * (statesRight + statesWrong), figures);
    }

    private static TrueFace TruthOf(ObjectLabel label, IReadOnlyList<TrueFace> faces) =>
        Assert.Single(faces, face => (face.Centre - label.Box3D.Centre).Length < SamePlaceMetres);

    // Heads of at least 12 pixels that hardly anything hides, up to the 60 degrees of turn of the project's other figures.
    private static bool IsClear(ObjectLabel head) =>
        head.Box2D.Height >= MinHeadPixels
        && head.OccludedFraction <= MaxHidden
        && head.TruncatedFraction <= MaxHidden
        && head.Face!.FacingAngleDegrees <= ReadUpToDegrees;
}
