using GTA.Hosting;
using GTA.Native;
using Harvester.Geometry;
using Harvester.Mod.Tests.Games.Natives;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Tests.Faces.Survey;

namespace Harvester.Mod.Tests.Games;

/// <summary>The natives about objects that scripts make.</summary>
internal sealed partial class TestGame
{
    /// <summary>The models of objects, by their names.</summary>
    public Dictionary<string, Prop> Props { get; } = [];

    public bool ObjectPoolIsFull { get; set; }

    public IEnumerable<GameEntity> Objects => Entities.Values.Where(entity => entity.Pool == PoolKind.Props);

    /// <summary>Models that scripts have requested and not released.</summary>
    public int RequestedModels => _ticksUntilLoaded.Count;

    /// <summary>The last states that scripts set for traffic lights, by handle.</summary>
    public Dictionary<int, int> LightOverrides { get; } = [];

    /// <summary>Told of each light that a script drives, and of the number that it is to show.</summary>
    public Action<int, int> LightDriven { get; set; } = (_, _) => { };

    /// <summary>A prop with the shape of its model: rays and the survey hit the same.</summary>
    public static GameEntity Standing(string name, Prop model, Pose pose) =>
        new()
        {
            Pool = PoolKind.Props,
            Name = name,
            Pose = pose,
            Shape = model.Shape,
            ModelMin = model.Shape.Min,
            ModelMax = model.Shape.Max,
            Bones = model.Bones,
        };

    private void AddObjectNatives()
    {
        Do(
            Hash.SET_ENTITY_TRAFFICLIGHT_OVERRIDE,
            a =>
            {
                Assert.True(Entities.ContainsKey((int)a[0]));
                LightDriven((int)a[0], (int)a[1]);
                const int gamesOwn = 3;
                if ((int)a[1] == gamesOwn)
                {
                    LightOverrides.Remove((int)a[0]);
                }
                else
                {
                    LightOverrides[(int)a[0]] = (int)a[1];
                }
            }
        );
        _natives[Hash.CREATE_OBJECT_NO_OFFSET] = a =>
        {
            Assert.Equal([false, false, false], a[4..]);
            return ObjectPoolIsFull ? 0 : CreateObject((int)a[0], ToWorld(a[1], a[2], a[3]));
        };
        Do(Hash.FREEZE_ENTITY_POSITION, a => Entities[(int)a[0]].IsFrozen = (bool)a[1]);
        Do(
            Hash.DELETE_OBJECT,
            a =>
            {
                Remove(((NativeAddress)a[0]).Integer);
                Write(a[0], 0);
            }
        );
        _natives[Hash.GET_ENTITY_BONE_INDEX_BY_NAME] = a =>
        {
            int bone = int.Parse(((string)a[1])["traffic_light_".Length..], System.Globalization.CultureInfo.InvariantCulture);
            return bone < Entities[(int)a[0]].Bones.Count ? bone : -1;
        };
        _natives[Hash.GET_WORLD_POSITION_OF_ENTITY_BONE] = a =>
        {
            GameEntity entity = Entities[(int)a[0]];
            return ToGame(entity.Pose.ToWorld(entity.Bones[(int)a[1]]));
        };
    }

    private (string Name, Prop Prop)? PropOf(int model) =>
        Props.Where(prop => ModelHash.Of(prop.Key) == model).Select(prop => ((string, Prop)?)(prop.Key, prop.Value)).FirstOrDefault();

    private int CreateObject(int model, Vector3D place)
    {
        (string name, Prop prop) =
            HasLoaded(model) && PropOf(model) is { } found
                ? found
                : throw new InvalidOperationException("An object was made of a model that is not loaded.");
        return Make(Standing(name, prop, new Pose(place, Axes.Identity)));
    }
}
