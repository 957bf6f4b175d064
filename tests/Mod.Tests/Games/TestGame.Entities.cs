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
        _natives[Hash.GET_PED_BONE_INDEX] = a => JointOf((int)a[0], (int)a[1]) is null ? -1 : (int)a[1] % 100;
        _natives[Hash.GET_PED_BONE_COORDS] = a => ToGame(JointOf((int)a[0], (int)a[1]) ?? default);
        _natives[Hash.DOES_ENTITY_EXIST] = a => Entities.ContainsKey((int)a[0]);
        _natives[Hash.IS_ENTITY_VISIBLE] = a => Entities.TryGetValue((int)a[0], out GameEntity? entity) && !entity.IsHidden;
        Do(
            Hash.SET_ENTITY_VISIBLE,
            a =>
            {
                if (Entities.TryGetValue((int)a[0], out GameEntity? entity))
                {
                    entity.IsHidden = !(bool)a[1];
                }
            }
        );
        _natives[Hash.GET_ENTITY_ATTACHED_TO] = a => Entities[(int)a[0]].AttachedTo;
        _natives[Hash.GET_ENTITY_TYPE] = a =>
            Entities.TryGetValue((int)a[0], out GameEntity? entity)
                ? entity.Pool switch
                {
                    PoolKind.Peds => 1,
                    PoolKind.Vehicles => 2,
                    _ => 3,
                }
                : 0;
        _natives[Hash.GET_ENTITY_MODEL] = a => Entities.TryGetValue((int)a[0], out GameEntity? entity) ? entity.Model : 0;
        _natives[Hash.GET_ENTITY_COORDS] = a => ToGame(PositionOf((int)a[0]));
        _natives[Hash.GET_ENTITY_VELOCITY] = a =>
            ToGame(Entities.TryGetValue((int)a[0], out GameEntity? entity) ? entity.Velocity : default);
        _natives[Hash.GET_ENTITY_HEADING] = a => (float)Angles.HeadingDegrees(Entities[(int)a[0]].Pose.Axes.Forward);
        _natives[Hash.GET_OFFSET_FROM_ENTITY_IN_WORLD_COORDS] = a => ToGame(Entities[(int)a[0]].Pose.ToWorld(ToWorld(a[1], a[2], a[3])));
        _natives[Hash.GET_ENTITY_HEIGHT_ABOVE_GROUND] = a =>
            (float)(Entities.TryGetValue((int)a[0], out GameEntity? entity) ? entity.HeightAboveGround : 0);
        Do(
            Hash.GET_ENTITY_MATRIX,
            a =>
            {
                // Nothing is written for an entity that no longer exists.
                if (Entities.TryGetValue((int)a[0], out GameEntity? entity))
                {
                    Axes axes = entity.Pose.Axes;
                    (Vector3D right, Vector3D forward, Vector3D up) = entity.Matrix ?? (axes.Right, axes.Forward, axes.Up);
                    Write(a[1], ToGame(forward));
                    Write(a[2], ToGame(right));
                    Write(a[3], ToGame(up));
                    Write(a[4], ToGame(entity.Pose.Position));
                }
            }
        );
        Do(
            Hash.GET_MODEL_DIMENSIONS,
            a =>
            {
                if (Entities.Values.FirstOrDefault(entity => entity.Model == (int)a[0]) is { } known)
                {
                    Write(a[1], ToGame(known.ModelMin));
                    Write(a[2], ToGame(known.ModelMax));
                }
            }
        );
    }

    private Vector3D? JointOf(int ped, int bone) =>
        Entities.TryGetValue(ped, out GameEntity? entity) && PedBoneIds.JointOf(bone) is { } joint ? entity.Skeleton?[joint] : null;
}
