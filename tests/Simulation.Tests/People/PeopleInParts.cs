using Harvester.Sessions.Scenes;
using Harvester.Simulation.Game;
using Harvester.Simulation.Models;
using Harvester.Simulation.People;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Tests.People;

/// <summary>
/// Draws the present picture of a simulated game with a number of its own for every part of every body, several times finer than the
/// labels' image, so that the renderer tells which part of whom is seen where.
/// </summary>
internal sealed class PeopleInParts
{
    private const double SightRange = 350;
    private static readonly BodyPart[] Parts = Enum.GetValues<BodyPart>();
    private static readonly Dictionary<Mesh, (int Person, int Posture)> Known = Postures();
    private static readonly Dictionary<(Mesh Whole, BodyPart Part), Mesh> Made = [];

    private readonly Dictionary<int, MeshInstance> _people = [];
    private readonly CameraState _camera;
    private readonly int _width;
    private readonly int _height;
    private readonly Lazy<RenderTarget> _picture;
    private readonly Lazy<RenderTarget> _alone;

    public PeopleInParts(SimulatedGame game, int width, int height, int finer)
    {
        (_width, _height, Finer) = (width * finer, height * finer, finer);
        _camera = game.Shown.Camera;
        List<MeshInstance> moving = [];
        foreach (MeshInstance instance in game.World.MovingNear(_camera.Pose.Position, SightRange))
        {
            if (Known.ContainsKey(instance.Mesh))
            {
                _people[instance.Handle] = instance;
                moving.AddRange(Parts.Select(part => Part(instance, part)));
            }
            else
            {
                moving.Add(instance);
            }
        }

        var scene = new RenderScene(game.World.Scene, moving);
        _picture = new(() => Draw(scene, NewTarget()));
        _alone = new(NewTarget);
    }

    /// <summary>How many pixels of the picture, across and down, lie on one of the image.</summary>
    public int Finer { get; }

    /// <summary>The picture of the whole scene.</summary>
    public RenderTarget Picture => _picture.Value;

    /// <summary>Whose part a number of the picture is; null for anything but a person.</summary>
    public static (int Handle, BodyPart Part)? Read(int number) => number >= 0 ? null : (-number / 16, (BodyPart)(-number % 16));

    /// <summary>A person's instance in the scene.</summary>
    public MeshInstance Whole(int handle) => _people[handle];

    /// <summary>The joints of the posture in which a person is drawn, metres, world.</summary>
    public Skeleton SkeletonOf(int handle)
    {
        (int person, int posture) = Known[_people[handle].Mesh];
        return ModelCatalogue.Shared.Pedestrians[person].Skeletons[posture].MovedBy(_people[handle].Pose);
    }

    /// <summary>A part of a person, alone.</summary>
    public MeshInstance PartOf(int handle, BodyPart part) => Part(_people[handle], part);

    /// <summary>Draws some instances with nothing else in the world. The next call draws into the same target.</summary>
    public RenderTarget DrawAlone(params MeshInstance[] instances) => Draw(new RenderScene(new RenderScene([]), instances), _alone.Value);

    private static Dictionary<Mesh, (int Person, int Posture)> Postures()
    {
        IReadOnlyList<Model> models = ModelCatalogue.Shared.Pedestrians;
        return (
            from person in Enumerable.Range(0, models.Count)
            from posture in Enumerable.Range(0, models[person].Variants.Count)
            select (models[person].Variants[posture], (person, posture))
        ).ToDictionary();
    }

    private static MeshInstance Part(MeshInstance whole, BodyPart part)
    {
        if (!Made.TryGetValue((whole.Mesh, part), out Mesh? mesh))
        {
            (int number, int posture) = Known[whole.Mesh];
            Person person = PedestrianModels.People[number];
            Dictionary<BodyPart, MeshBuilder> builders = Parts.ToDictionary(each => each, _ => new MeshBuilder());
            new BodyMesher(person, PersonPoses.Of(person)[posture], each => builders[each]).AddAll();
            foreach ((BodyPart each, MeshBuilder builder) in builders)
            {
                Made[(whole.Mesh, each)] = builder.Build();
            }

            mesh = Made[(whole.Mesh, part)];
        }

        return new MeshInstance(mesh, whole.Pose, -((whole.Handle * 16) + (int)part));
    }

    private RenderTarget NewTarget() => new(_width, _height);

    private RenderTarget Draw(RenderScene scene, RenderTarget target)
    {
        RenderCamera camera = new(_camera.Pose, _camera.VerticalFovDegrees, _camera.WindowAspect, _camera.NearClip, _width, _height);
        new Renderer().Render(scene, camera, target);
        return target;
    }
}
