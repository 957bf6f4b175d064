using Harvester.Capture.Playing;
using Harvester.Capture.Ports;
using Harvester.Capture.Settings;
using Harvester.Capture.Spaces;

namespace Harvester.Mod;

/// <summary>The test car of the thesis: spawned beside the player, and one at a time.</summary>
internal sealed class TestCar : IFeature
{
    private const double LoadMilliseconds = 10_000;
    private const float MetresBesidePlayer = 4;
    private const int MetallicBlack = 0;
    private const int MetallicOrange = 38;
    private readonly PlayerSettings _settings;
    private readonly PlayerMessages _messages;
    private readonly IClock _clock;
    private double _requestedAt;
    private int _requestedModel;
    private int _car;

    public TestCar(PlayerSettings settings, PlayerMessages messages, IClock clock)
    {
        _clock = clock;
        _settings = settings;
        _messages = messages;
    }

    /// <inheritdoc/>
    public string Name => "The test car";

    /// <summary>Asks for a car; it appears when the game has loaded its model, some ticks later.</summary>
    public void Spawn()
    {
        int model = ModelHash.Of(_settings.CarModel);
        if (!Natives.IsVehicleModel(model))
        {
            _messages.Tell($"The game has no vehicle '{_settings.CarModel}'. Change Model under [TestCar] in GtaDataHarvester.ini.");
            return;
        }

        _requestedModel = model;
        _requestedAt = _clock.Milliseconds;
        Natives.RequestModel(model);
    }

    /// <inheritdoc/>
    public void Tick()
    {
        if (_requestedModel == 0)
        {
            return;
        }

        if (Natives.HasModelLoaded(_requestedModel))
        {
            int model = _requestedModel;
            _requestedModel = 0;
            Replace(model);
            Natives.ReleaseModel(model);
        }
        else if (_clock.Milliseconds - _requestedAt > LoadMilliseconds)
        {
            Stop();
            _messages.Tell($"The game did not load the vehicle '{_settings.CarModel}'. Try again in a moment.");
        }
        else
        {
            Natives.RequestModel(_requestedModel);
        }
    }

    /// <inheritdoc/>
    public void Stop() => _requestedModel = 0;

    /// <summary>Takes the car out of the game.</summary>
    public void Remove()
    {
        int car = _car;
        _car = 0;
        if (car != 0 && Natives.EntityExists(car))
        {
            Natives.DeleteVehicle(car);
        }
    }

    private void Replace(int model)
    {
        Remove();
        int player = Natives.PlayerPed();
        int car = Natives.CreateVehicle(model, Natives.PointBeside(player, MetresBesidePlayer), Natives.EntityHeading(player));
        if (car == 0 || !Natives.EntityExists(car))
        {
            _messages.Tell("The game has no room for another vehicle. Try again away from traffic.");
            return;
        }

        _car = car;
        Natives.PlaceOnGround(car);
        Natives.MakeUnbreakable(car);
        Natives.Paint(car, MetallicBlack, MetallicOrange);
        Natives.SetPlate(car, _settings.CarPlate);
        _messages.Tell("The test car is here.");
    }
}
