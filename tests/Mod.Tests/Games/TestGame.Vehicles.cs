using GTA.Hosting;
using GTA.Native;
using Harvester.Geometry;

namespace Harvester.Mod.Tests.Games;

/// <summary>The natives about vehicles and their models.</summary>
internal sealed partial class TestGame
{
    private const int TicksToLoadAModel = 3;

    private void AddVehicleNatives()
    {
        _natives[Hash.IS_PED_IN_ANY_VEHICLE] = _ => PlayersVehicle != 0;
        _natives[Hash.GET_VEHICLE_PED_IS_IN] = _ => PlayersVehicle;
        _natives[Hash.IS_MODEL_IN_CDIMAGE] = a => (int)a[0] == Adder;
        _natives[Hash.IS_MODEL_A_VEHICLE] = a => (int)a[0] == Adder;
        _natives[Hash.REQUEST_MODEL] = a =>
        {
            _ticksUntilLoaded.TryAdd((int)a[0], TicksToLoadAModel);
            return null;
        };
        _natives[Hash.HAS_MODEL_LOADED] = a => ModelsLoad && _ticksUntilLoaded.TryGetValue((int)a[0], out int ticks) && ticks <= 0;
        _natives[Hash.SET_MODEL_AS_NO_LONGER_NEEDED] = a =>
        {
            _ticksUntilLoaded.Remove((int)a[0]);
            return null;
        };
        _natives[Hash.CREATE_VEHICLE] = a => VehiclePoolIsFull ? 0 : Create((int)a[0], ToWorld(a[1], a[2], a[3]), (float)a[4]);
        _natives[Hash.SET_ENTITY_AS_MISSION_ENTITY] = _ => null;
        _natives[Hash.DELETE_VEHICLE] = a =>
        {
            int handle = ((OutputArgument)a[0]).GetResult<int>();
            Entities.Remove(handle);
            PlayersVehicle = PlayersVehicle == handle ? 0 : PlayersVehicle;
            Write(a[0], 0);
            return null;
        };
        Set(Hash.SET_VEHICLE_ON_GROUND_PROPERLY, (car, _) => car.IsOnGround = true);
        Set(Hash.SET_VEHICLE_TYRES_CAN_BURST, (car, a) => car.TyresCanBurst = (bool)a[1]);
        Set(Hash.SET_VEHICLE_CAN_BE_VISIBLY_DAMAGED, (car, a) => car.IsDamagedVisibly = (bool)a[1]);
        Set(Hash.SET_VEHICLE_WHEELS_CAN_BREAK, (car, a) => car.WheelsCanBreak = (bool)a[1]);
        Set(Hash.SET_VEHICLE_COLOURS, (car, a) => car.Colours = ((int)a[1], (int)a[2]));
        Set(Hash.SET_VEHICLE_NUMBER_PLATE_TEXT, (car, a) => car.Plate = (string)a[1]);
    }

    /// <summary>The hash of "adder", as the game's lists of vehicles give it.</summary>
    public const int Adder = unchecked((int)0xB779A091);

    private int Create(int model, Vector3D position, float headingDegrees) =>
        HasLoaded(model)
            ? Add(new GameEntity { Pool = PoolKind.Vehicles, Model = model, Pose = new Pose(position, Axes.FromHeading(headingDegrees)) })
            : throw new InvalidOperationException("A vehicle was made of a model that is not loaded.");

    private bool HasLoaded(int model) => _ticksUntilLoaded.TryGetValue(model, out int ticks) && ticks <= 0;

    private void Set(Hash native, Action<GameEntity, object[]> change) => _natives[native] = a =>
    {
        change(Entities[(int)a[0]], a);
        return null;
    };
}
