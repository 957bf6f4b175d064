using GTA.Hosting;
using GTA.Native;
using Harvester.Geometry;

namespace Harvester.Mod.Tests.Games;

/// <summary>The natives about entities.</summary>
internal sealed partial class TestGame
{
    private void AddEntityNatives()
    {
        _natives[Hash.PLAYER_PED_ID] = _ => Player;
        _natives[Hash.IS_PED_HUMAN] = a => Entities[(int)a[0]].Name != "a_c_deer";
        _natives[Hash.DOES_ENTITY_EXIST] = a => Entities.ContainsKey((int)a[0]);
        _natives[Hash.GET_ENTITY_TYPE] = a => Entities.TryGetValue((int)a[0], out GameEntity? entity)
            ? entity.Pool switch { PoolKind.Peds => 1, PoolKind.Vehicles => 2, _ => 3 }
            : 0;
        _natives[Hash.GET_ENTITY_MODEL] = a => Entities.TryGetValue((int)a[0], out GameEntity? entity) ? entity.Model : 0;
        _natives[Hash.GET_ENTITY_COORDS] = a => ToGame(Entities[PlayersVehicle != 0 && (int)a[0] == Player ? PlayersVehicle : (int)a[0]].Pose.Position);
        _natives[Hash.GET_ENTITY_VELOCITY] = a => ToGame(Entities.TryGetValue((int)a[0], out GameEntity? entity) ? entity.Velocity : default);
        _natives[Hash.GET_ENTITY_HEADING] = a => (float)Angles.HeadingDegrees(Entities[(int)a[0]].Pose.Axes.Forward);
        _natives[Hash.GET_OFFSET_FROM_ENTITY_IN_WORLD_COORDS] = a => ToGame(Entities[(int)a[0]].Pose.ToWorld(ToWorld(a[1], a[2], a[3])));
        Do(Hash.GET_ENTITY_MATRIX, a =>
        {
            // The matrix of what is gone is all zeros.
            Pose pose = Entities.TryGetValue((int)a[0], out GameEntity? entity) ? entity.Pose : default;
            Write(a[1], ToGame(pose.Axes.Forward));
            Write(a[2], ToGame(pose.Axes.Right));
            Write(a[3], ToGame(pose.Axes.Up));
            Write(a[4], ToGame(pose.Position));
        });
        Do(Hash.GET_MODEL_DIMENSIONS, a =>
        {
            GameEntity? known = Entities.Values.FirstOrDefault(entity => entity.Model == (int)a[0]);
            Write(a[1], ToGame(known?.ModelMin ?? default));
            Write(a[2], ToGame(known?.ModelMax ?? default));
        });
    }
}
