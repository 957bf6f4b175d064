using Harvester.Capture.Labels;
using Harvester.Capture.Scenes;

namespace Harvester.Simulation.Tests.Spaces;

/// <summary>Faces of labels against the faces that the pictures truly show.</summary>
public sealed class LabelledFacesTests
{
    /// <summary>What the project asks of precision and of recall.</summary>
    private const double LeastShare = 0.98;

    /// <summary>What the project asks of the states of lights.</summary>
    private const double LeastRight = 0.99;

    /// <summary>Faces of less than the smallest box that is labelled are slivers: neither wanted nor wrong.</summary>
    private const int SliverPixels = 16;

    /// <summary>A label is of the face at its place; a session's numbers are rounded nowhere before the file.</summary>
    private const double SamePlaceMetres = 1e-9;
    private const double LowestHeadPixels = 12;
    private const double MostHidden = 0.05;

    [Fact]
    public void Labelled_faces_are_the_visible_ones_and_lights_are_read() => Judge(StreetOfFaces.Harvest(60, firstSeed: 1), fewestFaces: 300, fewestHeads: 30);

    [Fact]
    [Trait("Category", "Heavy")]
    public void Labelled_faces_are_the_visible_ones_and_lights_are_read_in_1000_frames() =>
        Judge(StreetOfFaces.Harvest(1_000, firstSeed: 1_000), fewestFaces: 5_000, fewestHeads: 500);

    [Fact]
    public void Lights_that_the_harvester_drives_are_labelled_as_set()
    {
        int heads = 0;
        foreach ((FrameLabel label, IReadOnlyList<TrueFace> faces) in StreetOfFaces.Harvest(3, firstSeed: 1, setsLights: true))
        {
            foreach (ObjectLabel head in label.Objects.Where(label => label.Space?.Light is not null))
            {
                Assert.Equal(new LightLabel(TruthOf(head, faces).State!.Value, LightMethod.Set, null), head.Space!.Light);
                heads++;
            }
        }

        Assert.True(heads > 5, $"Only {heads} heads.");
    }

    private static void Judge(IEnumerable<(FrameLabel Label, IReadOnlyList<TrueFace> Faces)> frames, int fewestFaces, int fewestHeads)
    {
        int right = 0, wrong = 0, missed = 0, statesRight = 0, statesWrong = 0;
        foreach ((FrameLabel label, IReadOnlyList<TrueFace> faces) in frames)
        {
            ObjectLabel[] labelled = [.. label.Objects.Where(item => item.Space is { FacesCamera: true })];
            foreach (ObjectLabel item in labelled)
            {
                TrueFace truth = TruthOf(item, faces);
                right += truth.FacesCamera && truth.VisiblePixels > 0 ? 1 : 0;
                wrong += truth.FacesCamera && truth.VisiblePixels > 0 ? 0 : 1;
                if (item.Class == ObjectClass.TrafficLight && IsClear(item))
                {
                    bool isRight = item.Space!.Light!.State == truth.State;
                    statesRight += isRight ? 1 : 0;
                    statesWrong += isRight ? 0 : 1;
                }
            }

            missed += faces.Count(face => face.FacesCamera && face.VisiblePixels >= SliverPixels
                && !labelled.Any(item => (item.Box3D.Centre - face.Centre).Length < SamePlaceMetres));
        }

        string figures = $"right {right}, wrong {wrong}, missed {missed}; states right {statesRight}, wrong {statesWrong}";
        Assert.True(right >= fewestFaces && statesRight >= fewestHeads, figures);
        Assert.True(right >= LeastShare * (right + wrong), figures);
        Assert.True(right >= LeastShare * (right + missed), figures);
        Assert.True(statesRight >= LeastRight * (statesRight + statesWrong), figures);
    }

    private static TrueFace TruthOf(ObjectLabel label, IReadOnlyList<TrueFace> faces) =>
        Assert.Single(faces, face => (face.Centre - label.Box3D.Centre).Length < SamePlaceMetres);

    // Heads of at least 12 pixels that hardly anything hides, up to the 60 degrees of turn of the project's other figures.
    private static bool IsClear(ObjectLabel head) =>
        head.Box2D.Height >= LowestHeadPixels && head.OccludedFraction <= MostHidden && head.TruncatedFraction <= MostHidden && head.Space!.FacingAngleDegrees <= 60;
}
