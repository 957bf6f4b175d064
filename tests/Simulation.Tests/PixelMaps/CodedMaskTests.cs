using System.Globalization;
using Harvester.Capture.Harvesting;
using Harvester.Capture.Labelling;
using Harvester.Geometry;
using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;
using Harvester.Sessions.Labels;
using Harvester.Simulation.Game;
using Harvester.Simulation.Rendering;
using Harvester.Simulation.Settings;
using Harvester.Simulation.Tests.Labelling;
using Harvester.TestSupport;
using Xunit.Abstractions;

namespace Harvester.Simulation.Tests.PixelMaps;

/// <summary>Masks from photographs in which objects are hidden, against what the pictures truly show.</summary>
public sealed class CodedMaskTests(ITestOutputHelper output)
{
    private const int LargePixels = 256;
    private const int SmallPixels = 16;
    private const int SmallEnd = 64;
    private const int MaxPictures = 17;
    private const int MaxRays = 500;

    /// <summary>Pictures of objects that do not overlap: of all, of none, of all before their screens, and of the screens.</summary>
    private const int MinPictures = 4;

    /// <summary>What is required.</summary>
    private const double MinMeanIou = 0.985;
    private const double MinIou = 0.90;

    /// <summary>
    /// Of five large objects, of which one is the rider of a bicycle: where both have nearly the same colour, no picture shows which is in
    /// front.
    /// </summary>
    private const double MinMeanIouWithRider = 0.97;

    private const double MinMeanAmodalIou = 0.97;

    private const double MinFound = 0.99;

    /// <summary>
    /// Pedestrians of the simulation walk through one another. Of two whose centres are so close, neither is before the other, and only
    /// the mean counts.
    /// </summary>
    private const double MergedMetres = 0.3;

    /// <summary>If more were, the lowest IoU of the others would say little.</summary>
    private const int MaxMerged = 4;

    /// <summary>What is reached by code words alone, without noise and shadows, so that a change for the worse is noticed.</summary>
    private const double MinMeanIouOfCodeWords = 0.90;

    /// <summary>The labelling range of <see cref="HarvestOptions"/>, metres.</summary>
    private const double RangeMetres = 150;

    /// <summary>Rays that meet boxes, noise of two grey levels, and moving textures; with Detail.Full also cast shadows.</summary>
    private static readonly GameQuirks Hard = new()
    {
        RaysMeetBoxes = true,
        PictureNoiseLevels = 2,
        TexturesMove = true,
    };

    [Fact]
    [Trait("Category", "Heavy")]
    public void Mask_is_made_from_few_pictures_and_rays()
    {
        Scores scores = Judge([61], 1, new ImageSize(400, 300), Detail.Plain, new GameQuirks { RaysMeetBoxes = true });

        Assert.InRange(scores.Large.Average(), MinMeanIouWithRider, 1);
        Assert.InRange(scores.MaxPictures, MinPictures, MaxPictures);
        Assert.InRange(scores.MaxRays, 0, MaxRays);
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Late_visibility_does_not_spoil_a_mask()
    {
        Scores scores = Judge(
            [61],
            1,
            new ImageSize(400, 300),
            Detail.Plain,
            new GameQuirks { VisibilityDelayTicks = 5, PictureLagTicks = 2 }
        );

        Assert.InRange(scores.Large.Average(), MinMeanIouWithRider, 1);
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Code_words_replace_screens_that_are_not_drawn()
    {
        var scores = new Scores();
        var game = new SimulatedGame(Town(61, Detail.Plain, new GameQuirks()));
        LabelledTown.Harvest(
            game,
            game.Ports with
            {
                Sheets = null,
            },
            Options(new ImageSize(400, 300), 1),
            (frame, truth) => Add(scores, game, frame, truth)
        );
        output.WriteLine(scores.ToString());

        Assert.InRange(scores.Large.Average(), MinMeanIouOfCodeWords, 1);
        Assert.InRange(scores.MaxPictures, MinPictures, MaxPictures);
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Objects_that_cannot_be_hidden_leave_masks_to_rays()
    {
        var game = new SimulatedGame(Town(61, Detail.Plain, new GameQuirks { UnhideableFraction = 1 }));
        HarvestOptions options = Options(new ImageSize(400, 300), 4);
        int pictures = 0;
        LabelledTown.Harvest(game, game.Ports, options, (frame, _) => pictures += frame.Label.PixelMap!.Pictures ?? 0);

        Assert.Equal(0, pictures);
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Hidden_objects_are_shown_again_for_the_next_frame()
    {
        var game = new SimulatedGame(Town(61, Detail.Plain, new GameQuirks { VisibilityDelayTicks = 3 }));
        LabelledTown.Harvest(
            game,
            game.Ports,
            Options(new ImageSize(400, 300), 2),
            (frame, _) =>
            {
                // The judge renders right after the frame, when everything asked for has taken effect.
                Assert.NotEmpty(frame.Label.Objects);
            }
        );
        for (int tick = 0; tick < 10; tick++)
        {
            game.Tick(1 / 60.0);
        }

        Assert.Empty(game.Hidden.Current);
    }

    /// <summary>
    /// These seeds were not looked at while the decoder was made; docs/pixel-maps.md has the figures.
    /// </summary>
    [Fact]
    [Trait("Category", "Heavy")]
    public void Masks_agree_with_pictures_despite_noise_and_shadows()
    {
        Scores scores = Judge(ProofSize.Of([701, 702], [701, 702, 703, 704, 705, 706]), 2, new ImageSize(800, 600), Detail.Full, Hard);

        Assert.InRange(scores.Large.Average(), MinMeanIou, 1);
        Assert.InRange(scores.Apart.Min(), MinIou, 1);
        Assert.InRange(scores.Large.Count - scores.Apart.Count, 0, MaxMerged);
        Assert.InRange(scores.SmallFound.Average(found => found ? 1.0 : 0), MinFound, 1);
        Assert.InRange(scores.Amodal.Average(), MinMeanAmodalIou, 1);
        Assert.InRange(scores.MaxPictures, MinPictures, MaxPictures);
        Assert.InRange(scores.MaxRays, 0, MaxRays);
    }

    /// <summary>Rays that meet what is drawn, and as many as the adaptive mapper wants.</summary>
    [Fact]
    [Trait("Category", "Heavy")]
    public void Masks_are_no_worse_than_those_of_exact_rays()
    {
        GameQuirks exact = Hard with { RaysMeetBoxes = false };
        int[] seeds = ProofSize.Of([707, 708], [707, 708, 709, 710]);
        Scores coded = Judge(seeds, 1, new ImageSize(800, 600), Detail.Full, exact);
        Scores rays = Judge(seeds, 1, new ImageSize(800, 600), Detail.Full, exact, MaskMethod.Rays);

        Assert.Equal(rays.Large.Count, coded.Large.Count);
        Assert.InRange(coded.Large.Average(), rays.Large.Average(), 1);
    }

    private static SimulationOptions Town(int seed, Detail detail, GameQuirks quirks) =>
        new()
        {
            Seed = seed,
            WindowAspect = 4.0 / 3,
            IsWarm = true,
            Detail = detail,
            TimeOfDay = TimeSpan.FromHours(9 + (seed % 8)),
            Quirks = quirks,
        };

    private static HarvestOptions Options(ImageSize image, int frames, MaskMethod method = MaskMethod.Coded) =>
        new()
        {
            Image = image,
            MaxFrames = frames,
            RangeMetres = RangeMetres,
            RateHz = 0.25,
            MaxOccludedFraction = 1,
            Masks = true,
            MaskMethod = method,
            MaxPictureLagTicks = 2,
        };

    private Scores Judge(int[] seeds, int frames, ImageSize image, Detail detail, GameQuirks quirks, MaskMethod method = MaskMethod.Coded)
    {
        var scores = new Scores();
        foreach (int seed in seeds)
        {
            var game = new SimulatedGame(Town(seed, detail, quirks));
            LabelledTown.Harvest(game, game.Ports, Options(image, frames, method), (frame, truth) => Add(scores, game, frame, truth));
        }

        output.WriteLine(scores.ToString());
        return scores;
    }

    private static void Add(Scores scores, SimulatedGame game, CapturedFrame frame, TruePicture truth)
    {
        scores.MaxPictures = Math.Max(scores.MaxPictures, frame.Label.PixelMap!.Pictures ?? 0);
        scores.MaxRays = Math.Max(scores.MaxRays, frame.Label.Rays!.Map);
        Dictionary<(string, Vector3D), int> handles = truth.Scene.Entities.ToDictionary(
            entity => (entity.Model, Cuboid.FromModel(entity.ModelMin, entity.ModelMax, entity.Pose).Centre),
            entity => entity.Handle
        );
        ImageSize image = frame.Mask!.Image;
        ObjectLabel[] objects = [.. frame.Label.Objects.Where(item => item.Parent is null)];
        int[] labelled = [.. objects.Select(item => handles[(item.Model, item.Box3D.Centre)])];
        foreach ((ObjectLabel item, int handle) in objects.Zip(labelled))
        {
            IReadOnlyList<int> pixels = truth.PixelsOf(handle);
            int shared = pixels.Count(pixel => frame.Mask.Ids[pixel] == item.Id);
            double iou = (double)shared / Math.Max(1, pixels.Count + frame.Mask.Ids.Count(number => number == item.Id) - shared);
            if (pixels.Count >= LargePixels)
            {
                scores.Large.Add(iou);
                if (objects.Count(other => (other.Box3D.Centre - item.Box3D.Centre).Length < MergedMetres) == 1)
                {
                    scores.Apart.Add(iou);
                }

                scores.Amodal.Add(item.AmodalMask is { } mask ? AmodalIou(game, mask.ToMap(image), handle, labelled) : 0);
            }
            else if (pixels.Count is >= SmallPixels and < SmallEnd)
            {
                scores.SmallFound.Add(shared > 0);
            }
        }

        // Objects that are seen and have no label were missed.
        HashSet<int> known = [.. labelled];
        foreach (int handle in truth.Scene.Entities.Where(entity => IsNear(truth, entity.Pose)).Select(entity => entity.Handle))
        {
            int pixels = known.Contains(handle) ? 0 : truth.PixelsOf(handle).Count;
            if (pixels >= LargePixels)
            {
                scores.Large.Add(0);
                scores.Apart.Add(0);
            }
            else if (pixels is >= SmallPixels and < SmallEnd)
            {
                scores.SmallFound.Add(false);
            }
        }
    }

    private static bool IsNear(TruePicture truth, Pose pose) => (pose.Position - truth.Scene.Camera.Pose.Position).Length < RangeMetres;

    /// <summary>Compares with the picture in which all other labelled objects are hidden.</summary>
    private static double AmodalIou(SimulatedGame game, PixelMap mask, int handle, int[] labelled)
    {
        RenderTarget alone = game.RenderWithout([.. labelled.Where(other => other != handle)], mask.Image);
        (int shared, int truth) = (0, 0);
        for (int pixel = 0; pixel < alone.Handles.Length; pixel++)
        {
            bool isTrue = alone.Handles[pixel] == handle;
            truth += isTrue ? 1 : 0;
            shared += isTrue && mask[pixel % mask.Image.Width, pixel / mask.Image.Width] ? 1 : 0;
        }

        return (double)shared / Math.Max(1, truth + mask.Count - shared);
    }

    private sealed class Scores
    {
        public List<double> Large { get; } = [];

        /// <summary>Those of <see cref="Large"/> that no other object stands in.</summary>
        public List<double> Apart { get; } = [];

        public List<double> Amodal { get; } = [];

        public List<bool> SmallFound { get; } = [];

        public int MaxPictures { get; set; }

        public int MaxRays { get; set; }

        public override string ToString() =>
            string.Create(
                CultureInfo.InvariantCulture,
                $"{Large.Count} large: mean {Large.Average():F4}, least {Large.Min():F3}; {Apart.Count} apart: least {Apart.Min():F3}; "
                    + $"amodal mean {Amodal.Average():F4}, least {Amodal.Min():F3}; small found {SmallFound.Count(found => found)} of "
                    + $"{SmallFound.Count}; at most {MaxPictures} pictures and {MaxRays} rays"
            );
    }
}
