"""The dataset of PyTorch."""

from __future__ import annotations

import pytest
from conftest import HandmadeSession
from gtaharvest import Selection, open_session

torch = pytest.importorskip("torch")
torch_dataset = pytest.importorskip("gtaharvest.torch_dataset")


def test_an_item_is_an_image_and_its_boxes(handmade: HandmadeSession) -> None:
    session = open_session(handmade.write())
    data = torch_dataset.DetectionDataset(session, selection=Selection(min_visible_fraction=0.5))
    image, target = data[1]
    assert image.shape == (3, 60, 80) and image.dtype == torch.float32
    # Red is three times the column.
    assert image[0, 5, 10].item() == pytest.approx(30 / 255)
    assert target["labels"].tolist() == [1] and target["ids"].tolist() == [7] and target["frame"].item() == 1
    assert target["boxes"][0].tolist() == pytest.approx(session[1].objects[0].box2d)
    # The pedestrian of unknown visibility, and the region beyond the range.
    assert target["ignore"].tolist() == [pytest.approx(session[1].objects[1].box2d), [1, 2, 3, 5]]


def test_objects_without_the_kind_of_box_are_ignored_regions(handmade: HandmadeSession) -> None:
    handmade.lines[1]["objects"][0]["box2dVisible"] = [37, 27, 43, 33]
    data = torch_dataset.DetectionDataset(handmade.write(), boxes="visible")
    assert data[1][1]["boxes"].tolist() == [[37, 27, 43, 33]] and len(data[1][1]["ignore"]) == 2
    assert data[0][1]["boxes"].shape == (0, 4) and data[0][1]["labels"].shape == (0,)
    with pytest.raises(ValueError, match="kinds are"):
        torch_dataset.DetectionDataset(handmade.folder, boxes="round")


def test_several_sessions_follow_one_another(handmade: HandmadeSession) -> None:
    folder = handmade.write()
    data = torch_dataset.DetectionDataset([folder, open_session(folder)], classes=["pedestrian"])
    assert len(data) == 6 and [data[i][1]["frame"].item() for i in range(6)] == [0, 1, 2, 0, 1, 2]
    assert data[-1][1]["ids"].tolist() == [9] and data[4][1]["labels"].tolist() == [1]
    with pytest.raises(IndexError):
        data[6]
    with pytest.raises(ValueError):
        torch_dataset.DetectionDataset([])


def test_a_transform_is_applied(handmade: HandmadeSession) -> None:
    data = torch_dataset.DetectionDataset(
        handmade.write(), transform=lambda image, target: (image.flip(-1), target["frame"])
    )
    image, frame = data[2]
    assert frame == 2 and image[0, 5, 79].item() == 0


@pytest.mark.parametrize("start", ["fork", "spawn"])
def test_several_workers_give_the_items_of_one(handmade: HandmadeSession, start: str) -> None:
    data = torch_dataset.DetectionDataset([handmade.write()] * 4)
    assert len(data[0]) == 2
    loader = torch.utils.data.DataLoader(
        data, batch_size=2, num_workers=2, collate_fn=torch_dataset.collate, multiprocessing_context=start
    )
    batches = list(loader)
    assert [target["frame"].item() for _, targets in batches for target in targets] == [0, 1, 2] * 4
    images = torch.cat([images for images, _ in batches])
    assert torch.equal(images, torch.stack([data[i][0] for i in range(12)]))
