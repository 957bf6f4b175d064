using Harvester.Geometry;
using Harvester.Simulation.Models;
using Harvester.Simulation.Rendering;
using Harvester.Simulation.Tests.Rendering;

namespace Harvester.Simulation.Tests.Models;

/// <summary>Whether the side view of a vehicle tells its kind, apart from its size.</summary>
public sealed class VehicleSilhouetteTests
{
    /// <summary>
    /// Maximum overlap of the side views of two kinds, each stretched to the same box. Two sedans of the game's sizes overlap by 0.97 and
    /// more; the most alike pair of kinds, a lorry with a box and a parcel van, by 0.95.
    /// </summary>
    private const double MaxOverlapOfKinds = 0.955;

    /// <summary>Side views of two models of one kind are at least this alike.</summary>
    private const double MinOverlapWithinKind = 0.96;

    private const int Pixels = 200;

    private static readonly string[] Kinds =
    [
        "asea",
        "blista",
        "banshee",
        "cheetah",
        "stratum",
        "landstalker",
        "minivan",
        "speedo",
        "rebel2",
        "boxville",
        "stockade",
        "biff",
        "packer",
        "trailers",
        "trailerlogs",
        "pbus",
        "bati",
        "hexer",
        "scorcher",
        "tropic",
    ];

    [Fact]
    public void Side_view_differs_between_any_two_kinds()
    {
        Dictionary<string, bool[]> views = Kinds.ToDictionary(name => name, SideView);
        var alike = new List<string>();
        for (int i = 0; i < Kinds.Length; i++)
        {
            for (int j = i + 1; j < Kinds.Length; j++)
            {
                double overlap = Overlap(views[Kinds[i]], views[Kinds[j]]);
                if (overlap > MaxOverlapOfKinds)
                {
                    alike.Add(FormattableString.Invariant($"{Kinds[i]} and {Kinds[j]}: {overlap:F3}"));
                }
            }
        }

        Assert.True(alike.Count == 0, string.Join("; ", alike));
    }

    [Theory]
    [InlineData("asea", "premier")]
    [InlineData("landstalker", "rocoto")]
    [InlineData("speedo", "pony")]
    [InlineData("trailers", "trailers")]
    public void Side_view_is_alike_within_a_kind(string one, string other) =>
        Assert.InRange(Overlap(SideView(one), SideView(other)), MinOverlapWithinKind, 1);

    /// <summary>The pixels of the model seen from its right, stretched to a square.</summary>
    private static bool[] SideView(string name)
    {
        const double distance = 400;
        Model model = ModelCatalogueTests.Catalogue[name];
        Vector3D size = model.Max - model.Min;
        Vector3D centre = (model.Min + model.Max) * 0.5;
        double fov = 2 * Math.Atan(size.Z / 2 / distance) * 180 / Math.PI;
        var camera = new RenderCamera(
            new Pose(new Vector3D(centre.X + distance, centre.Y, centre.Z), Axes.FromHeading(90)),
            fov,
            size.Y / size.Z,
            1,
            Pixels,
            Pixels
        );
        return [.. TestScene.Render(camera, TestScene.AtOrigin(model.Mesh, 1)).Handles.Select(handle => handle == 1)];
    }

    private static double Overlap(bool[] a, bool[] b)
    {
        int both = a.Where((covered, pixel) => covered && b[pixel]).Count();
        int either = a.Where((covered, pixel) => covered || b[pixel]).Count();
        return (double)both / either;
    }
}
