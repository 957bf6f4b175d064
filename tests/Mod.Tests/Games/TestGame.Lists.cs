using GTA.Hosting;
using GTA.Native;
using Harvester.Geometry;
using Harvester.Mod.Tests.Games.Natives;

namespace Harvester.Mod.Tests.Games;

/// <summary>The natives that list nearby entities. People know few entities, and only close ones.</summary>
internal sealed partial class TestGame
{
    private const int MaxKnown = 16;
    private const double MetresThatOneSees = 60;

    private void AddListNatives()
    {
        _natives[Hash.GET_PED_NEARBY_VEHICLES] = a => ((NativeAddress)a[1]).WriteList(KnownTo((int)a[0], PoolKind.Vehicles));
        _natives[Hash.GET_PED_NEARBY_PEDS] = a => ((NativeAddress)a[1]).WriteList(KnownTo((int)a[0], PoolKind.Peds));
        _natives[Hash.GET_CLOSEST_OBJECT_OF_TYPE] = a =>
        {
            Vector3D place = ToWorld(a[0], a[1], a[2]);
            return NearestTo(place, (float)a[3], entity => entity.Pool == PoolKind.Props && entity.Model == (int)a[4]).FirstOrDefault();
        };
    }

    private IEnumerable<int> KnownTo(int ped, PoolKind pool) =>
        NearestTo(PositionOf(ped), MetresThatOneSees, entity => entity.Pool == pool).Where(handle => handle != ped).Take(MaxKnown);

    private IEnumerable<int> NearestTo(Vector3D place, double radius, Func<GameEntity, bool> isWanted) =>
        Entities
            .Where(entity => isWanted(entity.Value))
            .Select(entity => (entity.Key, Distance: (PositionOf(entity.Key) - place).Length))
            .Where(entity => entity.Distance < radius)
            .OrderBy(entity => entity.Distance)
            .Select(entity => entity.Key);

    private Vector3D PositionOf(int handle) => Entities[PlayersVehicle != 0 && handle == Player ? PlayersVehicle : handle].Pose.Position;
}
