using GTA.Math;
using GTA.Native;
using Harvester.Geometry;
using Harvester.Geometry.Visibility;
using Harvester.Play.Features;
using Harvester.Play.Surveys.Faces;
using Harvester.Sessions.Scenes;

namespace Harvester.Mod;

/// <summary>Places models in the air above the player, where nothing else is, by the game's natives.</summary>
internal sealed class GameStage(IModels models, GameRays rays) : ISurveyStage
{
    private const double MetresOverPlayer = 40;
    private const int MaxHeads = 4;

    /// <inheritdoc/>
    public IRayCaster Rays => rays;

    /// <inheritdoc/>
    public ModelLoading Load(string model)
    {
        int hash = ModelHash.Of(model);
        return !Natives.ModelExists(hash) ? ModelLoading.Missing
            : models.Load(hash) ? ModelLoading.Loaded
            : ModelLoading.Loading;
    }

    /// <inheritdoc/>
    public void Release(string model) => models.Release(ModelHash.Of(model));

    /// <inheritdoc/>
    public int PutUp(string model)
    {
        Vector3D place = Natives.EntityPosition(Natives.PlayerPed()) + new Vector3D(0, 0, MetresOverPlayer);
        return Natives.Call<int>(
            Hash.CREATE_OBJECT_NO_OFFSET,
            ModelHash.Of(model),
            (float)place.X,
            (float)place.Y,
            (float)place.Z,
            false,
            false,
            false
        );
    }

    /// <inheritdoc/>
    public void Hold(int entity) => Natives.Call(Hash.FREEZE_ENTITY_POSITION, entity, true);

    /// <inheritdoc/>
    public StagedModel Read(int entity, string model)
    {
        Pose pose = Natives.EntityPose(entity);
        (Vector3D min, Vector3D max) = models.DimensionsOf(ModelHash.Of(model));
        var heads = new List<Vector3D>();
        for (int head = 0; head < MaxHeads; head++)
        {
            int bone = Natives.Call<int>(Hash.GET_ENTITY_BONE_INDEX_BY_NAME, entity, "traffic_light_" + head);
            if (bone >= 0)
            {
                heads.Add(pose.ToLocal(Natives.ToWorld(Natives.Call<Vector3>(Hash.GET_WORLD_POSITION_OF_ENTITY_BONE, entity, bone))));
            }
        }

        return new StagedModel(entity, pose, min, max, heads);
    }

    /// <inheritdoc/>
    public bool IsStanding(int entity) => Natives.EntityExists(entity);

    /// <inheritdoc/>
    public void TakeAway(int entity)
    {
        if (IsStanding(entity))
        {
            Natives.Delete(entity, Hash.DELETE_OBJECT);
        }
    }
}
