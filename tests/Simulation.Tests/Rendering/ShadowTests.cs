using Harvester.Geometry;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Tests.Rendering;

/// <summary>Shadows in pictures, against rays towards the sun from the places that the pixels show.</summary>
public sealed class ShadowTests
{
    /// <summary>
    /// Texels of the map of near shadows are 0.125 m wide, and four of them are mixed: what is nearer than two texels to the edge of a
    /// shadow may fall either way.
    /// </summary>
    private const double EdgeMetres = 0.25;

    /// <summary>Beyond this the map of distant shadows is used, whose texels are 0.8 m wide, metres.</summary>
    private const double NearMetres = 90;

    /// <summary>
    /// Surfaces are lifted by about a texel before they are looked up, or they would shade themselves; the foot of a shadow is lost.
    /// </summary>
    private const double MinAgreement = 0.985;

    private static readonly Lighting SunOnly = new()
    {
        AmbientColour = default,
        SunColour = TestScene.White,
        SunDirection = new Vector3D(0.5, -0.3, 0.7).Normalized(),
        FogDensity = 0,
        CloudFraction = 0,
    };

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    public void Pixels_are_dark_where_a_ray_to_the_sun_is_blocked(int seed)
    {
        RenderScene scene = TestScene.Seeded(seed);
        scene.Lighting = SunOnly;
        var above = new Pose(new Vector3D(0, -5, 18), Axes.FromEuler(new EulerAngles(-25, 0, 0)));
        RenderCamera camera = TestScene.SeededCamera(seed) with { Pose = above };
        RenderTarget picture = Render(new Renderer(Detail.Full), scene, camera);
        var rays = new SceneRayCaster(scene);
        var judged = new List<(bool IsBlocked, bool IsDark)>();
        for (int pixel = 0; pixel < picture.Depth.Length; pixel += 3)
        {
            if (!(picture.Depth[pixel] < NearMetres) || picture.Handles[pixel] != 0)
            {
                continue;
            }

            Vector3D place = PlaceOf(pixel, picture, camera);
            if (Math.Abs(place.Z + 1.5) > 0.001 || IsBlocked(rays, place) is not { } isBlocked)
            {
                continue;
            }

            judged.Add((isBlocked, picture.Colour[pixel * 3] < 64));
        }

        (bool IsBlocked, bool IsDark)[] blocked = [.. judged.Where(pixel => pixel.IsBlocked)];
        (bool IsBlocked, bool IsDark)[] open = [.. judged.Where(pixel => !pixel.IsBlocked)];
        Assert.True(open.Length > 1500 && blocked.Length > 100, $"Only {blocked.Length} of {judged.Count} pixels are in shadow.");
        Assert.InRange(blocked.Count(pixel => pixel.IsDark), blocked.Length * MinAgreement, blocked.Length);
        Assert.InRange(open.Count(pixel => !pixel.IsDark), open.Length * MinAgreement, open.Length);
    }

    [Fact]
    public void Shadows_change_colours_only()
    {
        RenderScene scene = TestScene.Seeded(4);
        RenderCamera camera = TestScene.SeededCamera(4);

        RenderTarget plain = Render(new Renderer(), scene, camera);
        RenderTarget full = Render(new Renderer(Detail.Full), scene, camera);

        Assert.NotEqual(plain.Colour, full.Colour);
        Assert.Equal(plain.Handles, full.Handles);
        Assert.Equal(plain.Depth, full.Depth);
    }

    [Fact]
    public void Picture_does_not_depend_on_earlier_pictures()
    {
        RenderScene scene = TestScene.Seeded(6);
        RenderScene other = TestScene.Seeded(7);
        RenderCamera camera = TestScene.SeededCamera(6);
        RenderCamera distant = camera with { Pose = new Pose(new Vector3D(40, 30, 1), camera.Pose.Axes) };
        var renderer = new Renderer(Detail.Full);

        byte[] first = Render(renderer, scene, camera).Colour;
        Render(renderer, other, camera);
        Render(renderer, scene, distant);
        byte[] again = Render(renderer, scene, camera).Colour;

        Assert.Equal(first, again);
    }

    [Fact]
    public void Ground_below_a_body_is_darker_under_a_grey_sky()
    {
        Mesh ground = new MeshBuilder()
            .AddQuad(new(-50, -50, -1), new(50, -50, -1), new(50, 50, -1), new(-50, 50, -1), TestScene.White, Surface.Matte)
            .Build();
        Mesh body = new MeshBuilder().AddBox(new(-1, 8, -0.7), new(1, 12, 0.5), TestScene.White).Build();
        var scene = new RenderScene([TestScene.AtOrigin(ground, 0)])
        {
            Lighting = new Lighting { SunColour = default, FogDensity = 0 },
        };
        scene.SetDynamic([TestScene.AtOrigin(body, 1)]);

        // Focal length 120 px, centre (160, 120). Ground 1 m below the eye, 9 m ahead, appears at row 120 + 120 / 9 = 133; 9 m ahead is
        // below the body, which leaves 0.3 m, and 4 m to the right of its middle is in the open.
        RenderTarget picture = Render(new Renderer(Detail.Full), scene, TestScene.Camera);

        byte below = picture.Colour[((133 * picture.Width) + 160) * 3];
        byte beside = picture.Colour[((133 * picture.Width) + 160 + (4 * 120 / 9)) * 3];
        Assert.Equal(0, picture.Handles[(133 * picture.Width) + 160]);
        Assert.InRange(below, 1, beside * 0.6);
    }

    private static RenderTarget Render(Renderer renderer, RenderScene scene, RenderCamera camera)
    {
        var target = new RenderTarget(camera.Width, camera.Height);
        renderer.Render(scene, camera, target);
        return target;
    }

    private static Vector3D PlaceOf(int pixel, RenderTarget picture, RenderCamera camera)
    {
        double focal = camera.Height / (2 * Math.Tan(camera.VerticalFovDegrees * Math.PI / 360));
        double depth = picture.Depth[pixel];
        double x = ((pixel % camera.Width) + 0.5 - (camera.Width / 2.0)) / focal;
        double z = -((pixel / camera.Width) + 0.5 - (camera.Height / 2.0)) / focal;
        return camera.Pose.ToWorld(new Vector3D(x * depth, depth, z * depth));
    }

    /// <summary>Whether the sun is hidden from a place and all around it; null near the edge of a shadow.</summary>
    private static bool? IsBlocked(SceneRayCaster rays, Vector3D place)
    {
        bool[] blocked =
        [
            .. new Vector3D[]
            {
                default,
                new(EdgeMetres, 0, 0),
                new(-EdgeMetres, 0, 0),
                new(0, EdgeMetres, 0),
                new(0, -EdgeMetres, 0),
            }.Select(aside => rays.Cast(new Ray(place + aside + new Vector3D(0, 0, 0.001), SunOnly.SunDirection), 1000, -1) is not null),
        ];
        return blocked.Distinct().Count() == 1 ? blocked[0] : null;
    }
}
