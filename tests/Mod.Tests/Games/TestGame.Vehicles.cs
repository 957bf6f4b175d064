using GTA.Hosting;
using GTA.Native;
using Harvester.Geometry;
using Harvester.Mod.Tests.Games.Natives;

namespace Harvester.Mod.Tests.Games;

/// <summary>The natives about vehicles and their models.</summary>
internal sealed partial class TestGame
{
    public const string Adder = "adder";

    /// <summary>The hash of "adder", as the game's lists of vehicles give it.</summary>
    public const int AdderHash = unchecked((int)0xB779A091);
    private const int TicksToLoadAModel = 3;

    public bool ModelsLoad { get; set; } = true;

    public bool VehiclePoolIsFull { get; set; }

    private void AddVehicleNatives()
    {
        _natives[Hash.IS_PED_IN_ANY_VEHICLE] = a => VehicleOf((int)a[0]) != 0;
        _natives[Hash.GET_VEHICLE_PED_IS_IN] = a => VehicleOf((int)a[0]);
        _natives[Hash.GET_VEHICLE_TRAILER_VEHICLE] = a =>
        {
            int trailer = Vehicles.Single(vehicle => HandleOf(vehicle) == (int)a[0]).Trailer;
            if (trailer != 0)
            {
                Write(a[1], trailer);
            }

            return trailer != 0;
        };
        _natives[Hash.GET_VEHICLE_CLASS] = a => Entities[(int)a[0]].VehicleClass;
        _natives[Hash.GET_DISPLAY_NAME_FROM_VEHICLE_MODEL] = a =>
            Vehicles.FirstOrDefault(vehicle => vehicle.Model == (int)a[0])?.Name.ToUpperInvariant() ?? "CARNOTFOUND";
        _natives[Hash.IS_MODEL_IN_CDIMAGE] = a => (int)a[0] == AdderHash || IsPedModel((int)a[0]) || PropOf((int)a[0]) is not null;
        _natives[Hash.IS_MODEL_A_VEHICLE] = a => (int)a[0] == AdderHash;
        Do(Hash.REQUEST_MODEL, a => _ticksUntilLoaded.TryAdd((int)a[0], TicksToLoadAModel));
        _natives[Hash.HAS_MODEL_LOADED] = a => ModelsLoad && HasLoaded((int)a[0]);
        Do(Hash.SET_MODEL_AS_NO_LONGER_NEEDED, a => _ticksUntilLoaded.Remove((int)a[0]));
        _natives[Hash.CREATE_VEHICLE] = a => VehiclePoolIsFull ? 0 : Create((int)a[0], ToWorld(a[1], a[2], a[3]), (float)a[4]);
        Do(Hash.SET_ENTITY_AS_MISSION_ENTITY, _ => { });
        Do(
            Hash.DELETE_VEHICLE,
            a =>
            {
                int handle = ((NativeAddress)a[0]).Integer;
                Remove(handle);
                PlayersVehicle = PlayersVehicle == handle ? 0 : PlayersVehicle;
                Write(a[0], 0);
            }
        );
        Do(Hash.SET_VEHICLE_ON_GROUND_PROPERLY, a => Entities[(int)a[0]].IsOnGround = true);
        Do(Hash.SET_VEHICLE_FIXED, a => Entities[(int)a[0]].Repairs++);
        Do(Hash.SET_ENTITY_INVINCIBLE, a => Entities[(int)a[0]].IsInvincible = (bool)a[1]);
        Do(Hash.SET_VEHICLE_ENGINE_CAN_DEGRADE, a => Entities[(int)a[0]].EngineCanDegrade = (bool)a[1]);
        Do(Hash.SET_DISABLE_VEHICLE_PETROL_TANK_DAMAGE, a => Entities[(int)a[0]].PetrolTankCanBeDamaged = !(bool)a[1]);
        Do(Hash.SET_VEHICLE_TYRES_CAN_BURST, a => Entities[(int)a[0]].TyresCanBurst = (bool)a[1]);
        Do(Hash.SET_VEHICLE_CAN_BE_VISIBLY_DAMAGED, a => Entities[(int)a[0]].IsDamagedVisibly = (bool)a[1]);
        Do(Hash.SET_VEHICLE_WHEELS_CAN_BREAK, a => Entities[(int)a[0]].WheelsCanBreak = (bool)a[1]);
        Do(Hash.SET_VEHICLE_COLOURS, a => Entities[(int)a[0]].Colours = ((int)a[1], (int)a[2]));
        Do(Hash.SET_VEHICLE_NUMBER_PLATE_TEXT, a => Entities[(int)a[0]].Plate = (string)a[1]);
    }

    private int VehicleOf(int ped) => ped == Player ? PlayersVehicle : Entities[ped].Vehicle;

    private int Create(int model, Vector3D position, float headingDegrees) =>
        HasLoaded(model) && model == AdderHash
            ? Make(
                new GameEntity
                {
                    Pool = PoolKind.Vehicles,
                    Name = Adder,
                    Pose = new Pose(position, Axes.FromHeading(headingDegrees)),
                }
            )
            : throw new InvalidOperationException("A vehicle was made of a model that is not loaded.");

    private bool HasLoaded(int model) => _ticksUntilLoaded.TryGetValue(model, out int ticks) && ticks <= 0;
}
